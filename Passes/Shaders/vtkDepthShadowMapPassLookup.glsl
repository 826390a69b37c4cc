// Visibility by depth map: each of the four texels around the receiver is compared, at its own centre,
// with the receiver's plane there. Needs SHADOW_DEPTH_MAP_SLOTS.

uniform sampler2DArray shadowDepthMaps;
// To the map's space: x, y and depth in 0..1. A matrix whose w is negative says: lit everywhere.
uniform mat4 shadowDepthMapFromView[SHADOW_DEPTH_MAP_SLOTS];
uniform float shadowDepthMapResolution;

// Depths of the texels (0,1), (1,1), (1,0), (0,0) beside the corner at `corner` (in texels).
vec4 shadowDepthMapGather(vec2 corner, int slot)
{
#ifdef GL_ARB_texture_gather
  return textureGather(shadowDepthMaps, vec3(corner / shadowDepthMapResolution, float(slot)));
#else
  ivec2 last = ivec2(int(shadowDepthMapResolution) - 1);
  ivec2 high = clamp(ivec2(floor(corner)), ivec2(0), last);
  ivec2 low = clamp(ivec2(floor(corner)) - 1, ivec2(0), last);
  return vec4(texelFetch(shadowDepthMaps, ivec3(low.x, high.y, slot), 0).r,
    texelFetch(shadowDepthMaps, ivec3(high, slot), 0).r,
    texelFetch(shadowDepthMaps, ivec3(high.x, low.y, slot), 0).r,
    texelFetch(shadowDepthMaps, ivec3(low, slot), 0).r);
#endif
}

float shadowDepthMapVisibility(int slot, vec4 positionVC)
{
  vec4 q = shadowDepthMapFromView[slot] * positionVC;
  vec3 p = q.xyz / q.w;
  p.xy *= shadowDepthMapResolution;

  // The receiver's plane in the map: depth change per texel, solved from the screen derivatives.
  vec3 dx = dFdx(p);
  vec3 dy = dFdy(p);
  float determinant = dx.x * dy.y - dx.y * dy.x;
  vec2 slope = vec2(dy.y * dx.z - dx.y * dy.z, dx.x * dy.z - dy.x * dx.z);
  slope = determinant != 0.0 ? slope / determinant : vec2(0.0);

  // Slack: rounding of the position (its terms may be far larger than their sum) and of the map, plus
  // half a texel of slope, for what the rasteriser did not put exactly at the texel's centre.
  const float ulp = 1.0 / 16777216.0;
  mat4 rows = transpose(shadowDepthMapFromView[slot]);
  vec4 size = abs(positionVC);
  float terms = (dot(abs(rows[2]), size) + abs(p.z) * dot(abs(rows[3]), size)) / q.w;
  float slack = (8.0 + 2.0 * terms) * ulp +
    0.5 * min(abs(slope.x) + abs(slope.y), 0.5 * shadowDepthMapResolution);

  vec2 corner = floor(p.xy - 0.5) + 1.0;
  vec2 f = p.xy + 0.5 - corner;
  vec4 depth = shadowDepthMapGather(corner, slot);
  vec2 low = corner - 0.5 - p.xy;
  vec2 high = low + 1.0;
  vec4 receiver = p.z - slack +
    vec4(dot(slope, vec2(low.x, high.y)), dot(slope, high), dot(slope, vec2(high.x, low.y)),
      dot(slope, low));
  // Beyond the farthest caster there is nothing but what was cleared to 1.
  vec4 lit = step(min(receiver, 1.0), depth);
  float visibility = mix(mix(lit.w, lit.z, f.x), mix(lit.x, lit.y, f.x), f.y);
  return q.w > 0.0 ? visibility : 1.0;
}
