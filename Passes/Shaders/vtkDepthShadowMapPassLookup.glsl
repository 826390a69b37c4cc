// Visibility by depth map: each of the four texels around the receiver is compared, at its own centre,
// with the receiver's plane there. SHADOW_DEPTH_MAP_WIDTH and _HEIGHT, a layer's texels, are defined ahead
// of this: a uniform costs a software rasteriser as much as a texture fetch.

uniform sampler2DArray shadowDepthMaps;

// Depths of the texels (0,1), (1,1), (1,0), (0,0) beside the corner at `corner` (in texels).
vec4 shadowDepthMapGather(int slot, vec2 corner)
{
#ifdef GL_ARB_texture_gather
  const vec2 perTexel = 1.0 / vec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT);
  return textureGather(shadowDepthMaps, vec3(corner * perTexel, float(slot)));
#else
  const ivec2 last = ivec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT) - 1;
  ivec2 high = clamp(ivec2(corner), ivec2(0), last);
  ivec2 low = clamp(ivec2(corner) - 1, ivec2(0), last);
  return vec4(texelFetch(shadowDepthMaps, ivec3(low.x, high.y, slot), 0).r,
    texelFetch(shadowDepthMaps, ivec3(high, slot), 0).r,
    texelFetch(shadowDepthMaps, ivec3(high.x, low.y, slot), 0).r,
    texelFetch(shadowDepthMaps, ivec3(low, slot), 0).r);
#endif
}

// p: texels, and depth less the bound of its rounding; slope: of the receiver's plane, in depth per texel.
float shadowDepthMapCompare(int slot, vec3 p, vec2 slope)
{
  // Half a texel of slope for what the rasteriser did not put exactly at the texel's centre.
  float rise = abs(slope.x) + abs(slope.y);
  float slack = min(0.5 * rise, 1.0);

  // Off the map nothing casts; one texel that stays in the cache stands for all of that.
  const vec2 middle = 0.5 * vec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT);
  vec2 beyond = abs(p.xy - middle) - middle;
  vec2 corner = max(beyond.x, beyond.y) <= 0.0 ? floor(p.xy + 0.5) : vec2(0.0);
  vec2 f = p.xy + 0.5 - corner;
  vec4 depth = shadowDepthMapGather(slot, corner);

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

// dx, dy: how p changes along two directions on the receiver's plane.
float shadowDepthMapCompare(int slot, vec3 p, vec3 dx, vec3 dy)
{
  // The receiver's plane in the map: depth change per texel.
  float determinant = dx.x * dy.y - dx.y * dy.x;
  float inverse = determinant != 0.0 ? 1.0 / determinant : 0.0;
  vec2 slope = vec2(dy.y * dx.z - dx.y * dy.z, dx.x * dy.z - dy.x * dx.z) * inverse;
  return shadowDepthMapCompare(slot, p, slope);
}

float shadowDepthMapParallel(int slot, vec4 q)
{
  return shadowDepthMapCompare(slot, q.xyz, dFdx(q.xyz), dFdy(q.xyz));
}

float shadowDepthMapParallel(int slot, vec4 q, vec4 dq1, vec4 dq2)
{
  return shadowDepthMapCompare(slot, q.xyz, dq1.xyz, dq2.xyz);
}

// Behind a light nothing was drawn.
float shadowDepthMapPerspective(int slot, vec4 q)
{
  vec3 p = q.xyz / q.w;
  float visibility = shadowDepthMapCompare(slot, p, dFdx(p), dFdy(p));
  return q.w > 0.0 ? visibility : 1.0;
}

float shadowDepthMapPerspective(int slot, vec4 q, vec4 dq1, vec4 dq2)
{
  vec3 p = q.xyz / q.w;
  float visibility =
    shadowDepthMapCompare(slot, p, (dq1.xyz - p * dq1.w) / q.w, (dq2.xyz - p * dq2.w) / q.w);
  return q.w > 0.0 ? visibility : 1.0;
}

#ifdef SHADOW_DEPTH_MAP_CUBES
// The six faces of each cube: depth = x + y / (depth before the light), z the layer, w texels per tangent. See
// Core/LightView.h for how they lie.
uniform vec4 shadowDepthMapFaces[6 * SHADOW_DEPTH_MAP_CUBES];

// q: as seen from the light, in the cube's axes; normal: of the receiver's plane. Neither knows of faces, so
// that it does not matter what face a neighbour is on.
float shadowDepthMapCube(int cube, vec4 q, vec3 normal)
{
  vec3 reach = abs(q.xyz);
  bool isX = reach.x >= max(reach.y, reach.z);
  bool isY = !isX && reach.y >= reach.z;
  vec3 r = isX ? q.yzx : isY ? q.zxy : q.xyz;
  vec2 n = isX ? normal.yz : isY ? normal.zx : normal.xy;
  vec4 face = shadowDepthMapFaces[6 * cube + (isX ? 0 : isY ? 2 : 4) + (r.z < 0.0 ? 1 : 0)];

  float inverse = 1.0 / r.z;
  float way = r.z < 0.0 ? -1.0 : 1.0;
  vec3 p = vec3(vec2(-face.w, face.w * way) * r.xy * inverse + 0.5 * float(SHADOW_DEPTH_MAP_HEIGHT),
    face.x + face.y * abs(inverse));

  // On the plane n.q = h the inverse of the depth is linear in the tangents.
  float h = dot(normal, q.xyz);
  vec2 slope = vec2(-way, 1.0) * n * (h != 0.0 ? face.y / (face.w * h) : 0.0);
  float visibility = shadowDepthMapCompare(int(face.z), p, slope);
  return q.w > 0.0 ? 1.0 : visibility;
}

float shadowDepthMapCube(int cube, vec4 q)
{
  return shadowDepthMapCube(cube, q, cross(dFdx(q.xyz), dFdy(q.xyz)));
}

float shadowDepthMapCube(int cube, vec4 q, vec4 dq1, vec4 dq2)
{
  return shadowDepthMapCube(cube, q, cross(dq1.xyz, dq2.xyz));
}
#endif
