// Filter "hardware": the driver compares the four texels around the receiver with one depth, and blends the
// answers. All four must see a lit surface lit: the farthest of their centres is a texel away along each
// axis, where its weight is none, and the rasteriser's half texel is added to that.
uniform sampler2DArrayShadow shadowDepthMaps;

float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  const vec2 perTexel = 1.0 / vec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT);
  float slack = shadowDepthMapSlack(slope, 1.5);
  vec2 at = shadowDepthMapWrapped(layer, p.xy);
  float reference = clamp(p.z - slack, 0.0, 1.0);
#ifdef SHADOW_DEPTH_MAP_STEP
  float reach = shadowDepthMapViews[layer].z * reference;
  reference = max(reach / (1.0 - reference + reach) - SHADOW_DEPTH_MAP_STEP, 0.0);
#endif
  return texture(shadowDepthMaps, vec4(at * perTexel, float(layer), reference));
}
