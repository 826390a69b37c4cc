// 2x2 percentage-closer filtering.

float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  vec2 corner = shadowDepthMapCorner(p.xy);
  return shadowDepthMapCompareFour(
    shadowDepthMapGather(layer, corner), p, slope, p.xy + 0.5 - corner);
}
