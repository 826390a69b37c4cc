//VTK::System::Dec

flat in uint shadowNumber;
out uint shadowTriangle;

void main()
{
  shadowTriangle = shadowNumber;
}
