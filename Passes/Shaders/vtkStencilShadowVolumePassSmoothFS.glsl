//VTK::System::Dec
// Visibility as a mean over n sample lights comes in steps of 1/n. Each pixel takes the mean of the widest disc
// around it in which nothing differs from it by much more than a step: a staircase becomes a ramp, and what is
// steeper, an edge, stays. So does what sees all of the light or none of it.
//VTK::Output::Dec

uniform sampler2DArray shadowSums;
uniform float shadowLargest; // difference that ends the disc

const int Radii[6] = int[6](1, 2, 4, 7, 11, 16); // pixels

void main()
{
  ivec2 last = textureSize(shadowSums, 0).xy - 1;
  ivec2 here = ivec2(gl_FragCoord.xy);
  float centre = texelFetch(shadowSums, ivec3(here, 0), 0).r;
  float sum = centre, weights = 1.0;
  float nothing = 0.125 * shadowLargest; // rounding of the sum, at most
  bool isBetween = centre > nothing && centre < 1.0 - nothing;
  for (int ring = 0; isBetween && ring < 6; ++ring)
  {
    float r = float(Radii[ring]);
    float ringSum = 0.0, apart = 0.0;
    for (int i = 0; i < 8; ++i)
    {
      float angle = 0.7853981634 * (float(i) + 0.5 * float(ring % 2));
      ivec2 there = clamp(here + ivec2(round(r * vec2(cos(angle), sin(angle)))), ivec2(0), last);
      float value = texelFetch(shadowSums, ivec3(there, 0), 0).r;
      ringSum += value;
      apart = max(apart, abs(value - centre));
    }
    if (apart > shadowLargest)
    {
      break;
    }
    sum += r * ringSum;
    weights += 8.0 * r;
  }
  gl_FragData[0] = vec4(sum / weights);
}
