// Visibility by the triangles that a depth map shows. A texel tells the surface that is nearest to the light at
// its centre; whether that surface reaches the receiver is found by walking over it, from triangle to
// neighbouring triangle, on the straight line from the texel's centre to the receiver. See
// vtkShadowTriangleMaps.h for what is in these textures, and Core/LightTriangles.h.
//
// A software rasteriser executes all of this for every fragment, and each loop at least once: what a frame does
// not need is left out by macros, and a loop leaves by one condition.

uniform usampler2DArray shadowDepthMapNumbers;
uniform samplerBuffer shadowDepthMapCorners; // three a triangle; w: the triangle beyond the side that follows

// Rasterisers move a vertex by up to half of 1/256 texel.
const float shadowDepthMapSnap = 1.0 / 256.0;
const int shadowDepthMapMostSteps = 24;

// The ray from the light to the receiver.
struct ShadowDepthMapRay
{
#ifdef SHADOW_DEPTH_MAP_DIRECT
  vec2 place; // the corners are in the map's own space
#else
  int face;
  vec2 place;    // where the ray is at the depth 0 of the corners' space
  vec2 perDepth; // and how it moves from there
  vec2 perTexel; // units a texel
#endif
  float depth;
};

// A corner: where it lies beside the ray, its depth, and what is beyond the side that follows.
vec4 shadowDepthMapVertex(ShadowDepthMapRay ray, int texel)
{
  vec4 v = texelFetch(shadowDepthMapCorners, texel);
#ifdef SHADOW_DEPTH_MAP_DIRECT
  return vec4(v.xy - ray.place, v.zw);
#else
#ifdef SHADOW_DEPTH_MAP_CUBES
  if (ray.face >= 0)
  {
    vec3 r = ray.face < 2 ? v.yzx : ray.face < 4 ? v.zxy : v.xyz;
    float way = (ray.face & 1) == 0 ? 1.0 : -1.0;
    v.xyz = vec3(-way * r.x, r.y, way * r.z);
  }
#endif
  return vec4(v.xy - ray.place - ray.perDepth * v.z, v.zw);
#endif
}

#ifdef SHADOW_DEPTH_MAP_DIRECT
ShadowDepthMapRay shadowDepthMapRayTo(int layer, vec2 p, float z)
{
  return ShadowDepthMapRay(p, z);
}
#define SHADOW_DEPTH_MAP_FROM_TEXELS(ray, way) (way)
#else
uniform vec4 shadowDepthMapPlanes[SHADOW_DEPTH_MAP_PLACES]; // texel of the axis; units a texel
uniform vec4 shadowDepthMapDepths[SHADOW_DEPTH_MAP_PLACES]; // where depths begin, their range; near, far (or 0)
uniform vec2 shadowDepthMapOthers[SHADOW_DEPTH_MAP_PLACES]; // face of a cube; the light's distance from depth 0

ShadowDepthMapRay shadowDepthMapRayTo(int layer, vec2 p, float z)
{
  vec4 plane = shadowDepthMapPlanes[layer];
  vec4 depths = shadowDepthMapDepths[layer];
  vec2 other = shadowDepthMapOthers[layer];
  vec2 place = (p - plane.xy) * plane.zw;
  bool parallel = depths.w == 0.0;
  float reach = z * depths.y;
  float depth = z >= 1.0 ? 3.0e38 : depths.x + (parallel ? reach : depths.z * reach / (depths.w - reach));
  return ShadowDepthMapRay(
    int(other.x), parallel ? place : place * other.y, parallel ? vec2(0.0) : place, plane.zw, depth);
}
#define SHADOW_DEPTH_MAP_FROM_TEXELS(ray, way) ((way) * ray.perTexel)
#endif

float shadowDepthMapCross(vec2 a, vec2 b)
{
  return a.x * b.y - a.y * b.x;
}

float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  vec2 corner = shadowDepthMapCorner(p.xy);
  vec2 f = p.xy + 0.5 - corner;
  vec4 depth = shadowDepthMapGather(layer, corner);

  // The receiver's plane at the four centres.
  float z = p.z - SHADOW_DEPTH_MAP_QUANTUM - min(shadowDepthMapSnap * shadowDepthMapRise(slope), 1.0);
  float atCorner = z - dot(slope, f);
  vec4 receiver =
    vec4(atCorner + slope.y, atCorner + slope.x + slope.y, atCorner + slope.x, atCorner);
  vec4 hides = vec4(lessThan(depth, min(receiver, 1.0)));

  // Where all four texels hide it by more than a surface through it would, it is in shadow, if only of one too thin
  // to be followed. Else the nearest of those that hide it comes first.
  float apart = 0.5 * shadowDepthMapRise(slope);
  bool isHidden = all(lessThan(depth, min(receiver - apart, 1.0)));
  vec2 g = 1.0 - f;
  const vec4 tieBreak = vec4(0.0012, 0.0014, 0.0016, 0.0018);
  vec4 rank = hides * (tieBreak + vec4(g.x * f.y, f.x * f.y, f.x * g.y, g.x * g.y));
#ifdef SHADOW_DEPTH_MAP_PLAIN
  bool isPlain = false;
#else
  rank *= isHidden ? 0.0 : 1.0;
#endif
  ShadowDepthMapRay ray = shadowDepthMapRayTo(layer, p.xy, z);
  float lit = isHidden ? 0.0 : 1.0;
  float best = max(max(rank.x, rank.y), max(rank.z, rank.w));
  for (int tried = 0; tried < 4; ++tried)
  {
    // Where there is none to try, what is executed nevertheless finds its texel in the cache.
    bvec4 chosen = equal(rank, vec4(best));
    vec2 centre = vec2(chosen.y || chosen.z ? 1.0 : 0.0, chosen.x || chosen.y ? 1.0 : 0.0);
    ivec2 place = best > 0.0 ? ivec2(corner + centre) - 1 : ivec2(0);
    uint at = texelFetch(shadowDepthMapNumbers, ivec3(place, layer), 0).r;
    at = best > 0.0 ? at : 0u;
    vec2 start = SHADOW_DEPTH_MAP_FROM_TEXELS(ray, centre - f);
#ifdef SHADOW_DEPTH_MAP_PLAIN
    isPlain = isPlain || (best > 0.0 && at == 0u);
#endif
    // A texel whose depth is that of the same surface need not be tried after it: see shadowDepthMapIsOnSurface.
    rank *= vec4(greaterThan(abs(depth - dot(depth, vec4(chosen))), vec4(8.0 * apart)));
    best = max(max(rank.x, rank.y), max(rank.z, rank.w));

    // From triangle to triangle, to the one that the ray passes through.
    for (int walked = 0; walked < shadowDepthMapMostSteps; ++walked)
    {
      int texel = max(3 * int(at) - 3, 0);
      vec4 a = shadowDepthMapVertex(ray, texel);
      vec4 b = shadowDepthMapVertex(ray, texel + 1);
      vec4 c = shadowDepthMapVertex(ray, texel + 2);
      // On which side of each side the ray passes; to a rounding, on it is within.
      vec3 weight = vec3(
        shadowDepthMapCross(b.xy, c.xy), shadowDepthMapCross(c.xy, a.xy), shadowDepthMapCross(a.xy, b.xy));
      vec2 size = abs(a.xy) + abs(b.xy) + abs(c.xy);
      bool isWithin = min(min(weight.x, weight.y), weight.z) >= -2.4e-7 * size.x * size.y;
      bool isHit = isWithin && at != 0u &&
        dot(weight, vec3(a.z, b.z, c.z)) < ray.depth * (weight.x + weight.y + weight.z);
      // Left or right of the way from the start to the ray: counter-clockwise, the way leaves the triangle
      // where its border goes from the right to the left.
      vec3 left = vec3(
        shadowDepthMapCross(a.xy, start), shadowDepthMapCross(b.xy, start), shadowDepthMapCross(c.xy, start));
      float beyond = left.x < 0.0 && left.y >= 0.0 ? a.w
        : left.y < 0.0 && left.z >= 0.0            ? b.w
        : left.z < 0.0 && left.x >= 0.0            ? c.w
                                                   : 0.0;
      lit = isHit ? 0.0 : lit;
      at = isWithin || at == 0u ? 0u : uint(beyond);
      if (at == 0u)
      {
        break;
      }
    }
    if (lit == 0.0 || best == 0.0)
    {
      break;
    }
  }
#ifdef SHADOW_DEPTH_MAP_PLAIN
  // Of what was drawn under no number, nothing but the depth is known.
  lit = isHidden && !isPlain ? 0.0 : lit;
  lit = isPlain ? min(lit, shadowDepthMapCompareFour(depth, p, slope, f)) : lit;
#endif
  return lit;
}
