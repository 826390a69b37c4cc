//VTK::System::Dec
// From a map of depths to a ramp: the share of the way from the near plane to the far one.
//VTK::Output::Dec

uniform sampler2DArray shadowDepths;
uniform float shadowNearOverFar; // 1: depths are linear

void main()
{
  float depth = texelFetch(shadowDepths, ivec3(gl_FragCoord.xy, 0), 0).r;
  gl_FragData[0] =
    vec4(shadowNearOverFar * depth / (1.0 - (1.0 - shadowNearOverFar) * depth));
}
