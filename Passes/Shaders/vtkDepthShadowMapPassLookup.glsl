// Depths around a receiver, and its comparison with them: each of the four texels is compared, at its own
// centre, with the receiver's plane there.

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

// Between the four texels around p: its lower left texel has the centre corner - 0.5. Off the map nothing casts;
// one texel that stays in the cache stands for all of that.
vec2 shadowDepthMapCornerAt(vec2 p)
{
  const vec2 middle = 0.5 * vec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT);
  vec2 beyond = abs(p - middle) - middle;
  return max(beyond.x, beyond.y) <= 0.0 ? floor(p + 0.5) : vec2(0.0);
}

// p: texels, and depth less the bound of its rounding; slope: of the receiver's plane, in depth per texel; f: of p
// from the lower left centre.
float shadowDepthMapBlend(vec4 depth, vec3 p, vec2 slope, vec2 f)
{
  // Half a texel of slope for what the rasteriser did not put exactly at the texel's centre.
  float rise = abs(slope.x) + abs(slope.y);
  float slack = min(0.5 * rise, 1.0);

  // The plane at the four centres; beyond the farthest caster there is nothing but what was cleared to 1.
  float z = p.z - slack - dot(slope, f);
  vec4 receiver = vec4(z + slope.y, z + slope.x + slope.y, z + slope.x, z);
  vec4 lit = step(min(receiver, 1.0), depth);
  float visibility = mix(mix(lit.w, lit.z, f.x), mix(lit.x, lit.y, f.x), f.y);

  // Where a surface curves, its plane leaves it beside the receiver. If the four depths lie no farther apart
  // than those of one surface, up to four times as steep as the receiver, they are of one: what is not
  // behind it is lit.
  float nearest = min(min(depth.x, depth.y), min(depth.z, depth.w));
  float farthest = max(max(depth.x, depth.y), max(depth.z, depth.w));
  float surface = mix(mix(depth.w, depth.z, f.x), mix(depth.x, depth.y, f.x), f.y);
  bool isLit = farthest - nearest <= 4.0 * rise && p.z - slack <= surface;
  return isLit ? 1.0 : visibility;
}
