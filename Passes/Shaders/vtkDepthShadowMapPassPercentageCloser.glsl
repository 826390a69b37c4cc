// 2x2 percentage-closer filtering.

float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  vec2 corner = shadowDepthMapCornerAt(p.xy);
  return shadowDepthMapBlend(shadowDepthMapGather(layer, corner), p, slope, p.xy + 0.5 - corner);
}
