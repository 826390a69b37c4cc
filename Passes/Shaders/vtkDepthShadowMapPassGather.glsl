// Depths of a map's texels, and percentage-closer filtering of the four around a receiver.

uniform sampler2DArray shadowDepthMaps;

#ifdef SHADOW_DEPTH_MAP_RAMP
// From steps of the ramp to the depths at their far ends: what is held against them is in no later step.
vec4 shadowDepthMapOfRamp(int layer, vec4 ramp)
{
  float ratio = shadowDepthMapViews[layer].z;
  vec4 way = min(ramp + 0.5 / 255.0, 1.0);
  return way / (ratio + (1.0 - ratio) * way);
}
#else
#define shadowDepthMapOfRamp(layer, depth) (depth)
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
  return shadowDepthMapOfRamp(layer, depth);
}

// Percentage-closer filtering of the four texels around p: each is compared, at its own centre, with the
// receiver's plane there, and the four answers are blended.
float shadowDepthMapFourTexels(int layer, vec3 p, vec2 slope)
{
  float slack = shadowDepthMapSlack(slope, 0.5);
  vec2 plane = shadowDepthMapPlane(slope);
  vec2 corner = shadowDepthMapHolds(p.xy) ? floor(p.xy + 0.5) : vec2(0.0);
  vec2 f = p.xy + 0.5 - corner;
  vec4 depth = shadowDepthMapGather(layer, corner);

  // The plane at the four centres; beyond the farthest caster there is nothing but what was cleared to 1.
  float z = p.z - slack - dot(plane, f);
  vec4 receiver = vec4(z + plane.y, z + plane.x + plane.y, z + plane.x, z);
  vec4 lit = step(min(receiver, 1.0), depth);
  float visibility = mix(mix(lit.w, lit.z, f.x), mix(lit.x, lit.y, f.x), f.y);

#ifndef SHADOW_DEPTH_MAP_CONSTANT_BIAS
  // Where a surface curves, its plane leaves it beside the receiver. If the four depths lie no farther apart
  // than those of one surface, up to four times as steep as the receiver, they are of one: what is not
  // behind it is lit.
  float nearest = min(min(depth.x, depth.y), min(depth.z, depth.w));
  float farthest = max(max(depth.x, depth.y), max(depth.z, depth.w));
  float surface = mix(mix(depth.w, depth.z, f.x), mix(depth.x, depth.y, f.x), f.y);
  bool isOne = farthest - nearest <= 4.0 * (abs(slope.x) + abs(slope.y));
  visibility = isOne && p.z - slack <= surface ? 1.0 : visibility;
#endif
  return visibility;
}
