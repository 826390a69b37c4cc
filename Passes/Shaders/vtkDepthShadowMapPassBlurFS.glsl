//VTK::System::Dec
// One axis of a Gaussian over a map, first of depths, then of the moments that came of it: the way from the near
// plane to the far one and its square, or an exponential of it.
//VTK::Output::Dec

uniform sampler2DArray shadowSource;
uniform int shadowLayer;
uniform ivec2 shadowAxis;
uniform float shadowRadius;      // texels, two standard deviations
uniform float shadowNearOverFar; // 1: depths are linear; 0: the source holds moments
uniform float shadowExponent;    // 0: way and square

vec2 shadowMoments(float value)
{
  float way = shadowNearOverFar * value / (1.0 - (1.0 - shadowNearOverFar) * value);
  return shadowExponent > 0.0 ? vec2(exp(shadowExponent * (way - 1.0)), 0.0) : vec2(way, way * way);
}

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(shadowSource, 0).xy - 1;
  int reach = int(shadowRadius);
  vec2 sum = vec2(0.0);
  float weights = 0.0;
  for (int i = -reach; i <= reach; ++i)
  {
    float weight = exp(-2.0 * float(i * i) / (shadowRadius * shadowRadius));
    vec2 value =
      texelFetch(shadowSource, ivec3(clamp(texel + i * shadowAxis, ivec2(0), last), shadowLayer), 0).rg;
    sum += weight * (shadowNearOverFar > 0.0 ? shadowMoments(value.r) : value);
    weights += weight;
  }
  gl_FragData[0] = vec4(sum / weights, 0.0, 1.0);
}
