// Depths of a map's texels, and percentage-closer filtering of the four around a receiver.

uniform sampler2DArray shadowDepthMaps;

#ifdef SHADOW_DEPTH_MAP_STEP
// From steps of the distance to the depths at their far ends: what is held against them is in no later step.
vec4 shadowDepthMapOfDistance(int layer, vec4 distance)
{
  vec4 way = min(distance + SHADOW_DEPTH_MAP_STEP, 1.0);
  return way / (way + shadowDepthMapViews[layer].z * (1.0 - way));
}
#else
#define shadowDepthMapOfDistance(layer, depth) (depth)
#endif

// Depths of the texels (0,1), (1,1), (1,0), (0,0) beside the corner at `corner` (in texels).
vec4 shadowDepthMapGather(int layer, vec2 corner)
{
#ifdef GL_ARB_texture_gather
  const vec2 perTexel = 1.0 / vec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT);
  vec4 depth = textureGather(shadowDepthMaps, vec3(corner * perTexel, float(layer)));
#else
  const ivec2 last = ivec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT) - 1;
  ivec2 high = clamp(ivec2(corner), ivec2(0), last);
  ivec2 low = clamp(ivec2(corner) - 1, ivec2(0), last);
  vec4 depth = vec4(texelFetch(shadowDepthMaps, ivec3(low.x, high.y, layer), 0).r,
    texelFetch(shadowDepthMaps, ivec3(high, layer), 0).r,
    texelFetch(shadowDepthMaps, ivec3(high.x, low.y, layer), 0).r,
    texelFetch(shadowDepthMaps, ivec3(low, layer), 0).r);
#endif
  return shadowDepthMapOfDistance(layer, depth);
}

// Each of the four texels is compared, at its own centre, with the receiver's plane there. f: from the centre of
// texel (0,0) to the receiver.
float shadowDepthMapCompareFour(vec4 depth, vec3 p, vec2 slope, vec2 f)
{
  p.z -= SHADOW_DEPTH_MAP_QUANTUM;
  float visibility = shadowDepthMapBlend(step(shadowDepthMapPlane(p, slope, f), depth), f);
  return shadowDepthMapIsOnSurface(depth, p, slope, f) ? 1.0 : visibility;
}

// Percentage-closer filtering of the four texels around p.
float shadowDepthMapFourTexels(int layer, vec3 p, vec2 slope)
{
  vec2 corner = shadowDepthMapCorner(p.xy);
  vec2 f = p.xy + 0.5 - corner;
  vec4 depth = shadowDepthMapGather(layer, corner);
#ifdef SHADOW_DEPTH_MAP_CONSTANT_BIAS
  float receiver = min(p.z - shadowDepthMapSlack(slope, 0.5), 1.0);
  return shadowDepthMapBlend(step(vec4(receiver), depth), f);
#else
  return shadowDepthMapCompareFour(depth, p, slope, f);
#endif
}
