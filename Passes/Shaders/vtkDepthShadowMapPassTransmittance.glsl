// What translucent casters let through of the light, beside what opaque ones do: percentage-closer, whatever the
// filter of those, over the share of light behind the nearest translucent surface of each texel.
uniform sampler2DArray shadowDepthMapTranslucents;
uniform sampler2DArray shadowDepthMapShares;

float shadowDepthMapTransmittance(int layer, vec3 p, vec2 slope)
{
  vec2 corner = shadowDepthMapCorner(p.xy);
  vec2 f = p.xy + 0.5 - corner;
#ifdef GL_ARB_texture_gather
  const vec2 perTexel = 1.0 / vec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT);
  vec3 at = vec3(corner * perTexel, float(layer));
  vec4 depth = textureGather(shadowDepthMapTranslucents, at);
  vec4 share = textureGather(shadowDepthMapShares, at);
#else
  const ivec2 last = ivec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT) - 1;
  ivec3 high = ivec3(clamp(ivec2(corner), ivec2(0), last), layer);
  ivec3 low = ivec3(clamp(ivec2(corner) - 1, ivec2(0), last), layer);
  ivec3 highLeft = ivec3(low.x, high.y, layer), lowRight = ivec3(high.x, low.y, layer);
  vec4 depth = vec4(texelFetch(shadowDepthMapTranslucents, highLeft, 0).r,
    texelFetch(shadowDepthMapTranslucents, high, 0).r,
    texelFetch(shadowDepthMapTranslucents, lowRight, 0).r,
    texelFetch(shadowDepthMapTranslucents, low, 0).r);
  vec4 share = vec4(texelFetch(shadowDepthMapShares, highLeft, 0).r,
    texelFetch(shadowDepthMapShares, high, 0).r, texelFetch(shadowDepthMapShares, lowRight, 0).r,
    texelFetch(shadowDepthMapShares, low, 0).r);
#endif
  vec4 lit = step(shadowDepthMapPlane(p, slope, f), depth);
  return shadowDepthMapIsOnSurface(depth, p, slope, f)
    ? 1.0
    : shadowDepthMapBlend(mix(share, vec4(1.0), lit), f);
}

float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  return shadowDepthMapCompareOpaque(layer, p, slope) * shadowDepthMapTransmittance(layer, p, slope);
}
