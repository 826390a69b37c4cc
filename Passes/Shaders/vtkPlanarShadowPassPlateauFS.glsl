//VTK::System::Dec
// A plateau: visibility rises without an edge at either end.
//VTK::Output::Dec

in float shadowVisibility;

void main()
{
  gl_FragData[0] = vec4(smoothstep(0.0, 1.0, shadowVisibility));
}
