//VTK::System::Dec
// From counts to visibility: in how many volumes the receiver of a pixel lies.
//VTK::Output::Dec

uniform sampler2DArray shadowCounts;
uniform int shadowParity;  // 1: an odd count is shadow; 0: a count above 0 is
uniform float shadowShare; // of this light in the mask

void main()
{
  float count = texelFetch(shadowCounts, ivec3(gl_FragCoord.xy, 0), 0).r;
  float shadow = shadowParity != 0 ? mod(abs(count), 2.0) : step(0.5, count);
  gl_FragData[0] = vec4(shadowShare * (1.0 - shadow));
}
