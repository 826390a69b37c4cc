// Depths around a receiver.

uniform sampler2DArray shadowDepthMaps;

// Depths of the texels (0,1), (1,1), (1,0), (0,0) beside the corner at `corner` (in texels).
vec4 shadowDepthMapGather(int layer, vec2 corner)
{
#ifdef GL_ARB_texture_gather
  const vec2 perTexel = 1.0 / vec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT);
  return textureGather(shadowDepthMaps, vec3(corner * perTexel, float(layer)));
#else
  const ivec2 last = ivec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT) - 1;
  ivec2 high = clamp(ivec2(corner), ivec2(0), last);
  ivec2 low = clamp(ivec2(corner) - 1, ivec2(0), last);
  return vec4(texelFetch(shadowDepthMaps, ivec3(low.x, high.y, layer), 0).r,
    texelFetch(shadowDepthMaps, ivec3(high, layer), 0).r,
    texelFetch(shadowDepthMaps, ivec3(high.x, low.y, layer), 0).r,
    texelFetch(shadowDepthMaps, ivec3(low, layer), 0).r);
#endif
}

// Each of the four texels is compared, at its own centre, with the receiver's plane there. f: from the centre of
// texel (0,0) to the receiver.
float shadowDepthMapCompareFour(vec4 depth, vec3 p, vec2 slope, vec2 f)
{
  float visibility = shadowDepthMapBlend(step(shadowDepthMapPlane(p, slope, f), depth), f);
  return shadowDepthMapIsOnSurface(depth, p, slope, f) ? 1.0 : visibility;
}
