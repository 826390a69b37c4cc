//VTK::System::Dec
// From a map of depths to one of the distance: the share of the way from the near plane to the far one, as a colour or
// as a depth. Written so that the far plane is exactly 1, and what is near to it keeps its digits.
//VTK::Output::Dec

uniform sampler2DArray shadowDepths;
uniform float shadowNearOverFar; // 1: depths are linear

void main()
{
  float depth = texelFetch(shadowDepths, ivec3(gl_FragCoord.xy, 0), 0).r;
  float way = shadowNearOverFar * depth / (1.0 - depth + shadowNearOverFar * depth);
  gl_FragData[0] = vec4(way);
  gl_FragDepth = way;
}
