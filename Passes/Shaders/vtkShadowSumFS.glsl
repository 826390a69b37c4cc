//VTK::System::Dec
// From a sum of shares, visibility.
//VTK::Output::Dec

uniform sampler2DArray shadowSums;

void main()
{
  gl_FragData[0] = vec4(texelFetch(shadowSums, ivec3(gl_FragCoord.xy, 0), 0).r);
}
