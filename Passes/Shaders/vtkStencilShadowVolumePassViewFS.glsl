//VTK::System::Dec
// A face or an edge of a shadow volume, drawn to be looked at.
//VTK::Output::Dec

uniform vec4 shadowViewColor;

void main()
{
  gl_FragData[0] = shadowViewColor;
}
