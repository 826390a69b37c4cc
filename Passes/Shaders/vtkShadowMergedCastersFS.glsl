//VTK::System::Dec
// As the shading's stage CASTERS has it.
//VTK::Output::Dec

void main()
{
  gl_FragData[0] = vec4(1.0, gl_FragCoord.z, 1.0, 1.0);
}
