// Filters "variance" (W. Donnelly, A. Lauritzen 2006) and "exponential" (T. Annen et al. 2008): of a map of moments
// that was blurred, one sample. Ahead of it stands SHADOW_DEPTH_MAP_BLEEDING, the share of visibility that is cut
// off against light bleeding, or SHADOW_DEPTH_MAP_EXPONENT.
float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  const vec2 perTexel = 1.0 / vec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT);
  float ratio = shadowDepthMapViews[layer].z;
  vec2 at = shadowDepthMapWrapped(layer, p.xy);
  vec2 moments = shadowDepthMapHolds(at)
    ? texture(shadowDepthMaps, vec3(at * perTexel, float(layer))).rg
    : vec2(1.0);

  // From depth to the share of the way from the near plane to the far one, as the moments are.
  float depth = clamp(p.z - shadowDepthMapSlack(slope, 0.5), 0.0, 1.0);
  float perDepth = ratio / ((1.0 - (1.0 - ratio) * depth) * (1.0 - (1.0 - ratio) * depth));
  float way = ratio * depth / (1.0 - (1.0 - ratio) * depth);
#ifdef SHADOW_DEPTH_MAP_EXPONENT
  return clamp(exp(SHADOW_DEPTH_MAP_EXPONENT * (1.0 - way)) * moments.x, 0.0, 1.0);
#else
  // The plane's own spread within the kernel, and what floats lose of a square.
  float spread = perDepth * length(shadowDepthMapTilt(slope)) * SHADOW_DEPTH_MAP_RADIUS;
  float variance = max(moments.y - moments.x * moments.x, 0.25 * spread * spread + 1.0e-7);
  float behind = way - moments.x;
  float most = variance / (variance + behind * behind);
  most = clamp((most - SHADOW_DEPTH_MAP_BLEEDING) / (1.0 - SHADOW_DEPTH_MAP_BLEEDING), 0.0, 1.0);
  return behind <= 0.0 ? 1.0 : most;
#endif
}
