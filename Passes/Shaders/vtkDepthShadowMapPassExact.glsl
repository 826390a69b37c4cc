// Visibility by the triangles that a depth map shows. A texel tells the surface that is nearest to the light at
// its centre; whether that surface reaches the receiver is found by walking over it, from triangle to
// neighbouring triangle, on the straight line from the texel's centre to the receiver. See
// vtkShadowTriangleMaps.h for what is in these textures, and Core/LightTriangles.h.

uniform usampler2DArray shadowDepthMapNumbers;
uniform samplerBuffer shadowDepthMapCorners;     // three a triangle, in its light's space
uniform usamplerBuffer shadowDepthMapNeighbours; // the same texels: w is the triangle beyond a side
uniform vec4 shadowDepthMapPlanes[SHADOW_DEPTH_MAP_LAYERS]; // texel of the axis; light units a texel
uniform vec4 shadowDepthMapDepths[SHADOW_DEPTH_MAP_LAYERS]; // where depths begin, their range; near, far (or 0)
uniform vec4 shadowDepthMapOthers[SHADOW_DEPTH_MAP_LAYERS]; // face of a cube; depth of the list's zero; rise

// Rasterisers move a vertex by up to half of 1/256 texel.
const float shadowDepthMapSnap = 1.0 / 256.0;
const int shadowDepthMapMostSteps = 24;

float shadowDepthMapCross(vec2 a, vec2 b)
{
  return a.x * b.y - a.y * b.x;
}

// A corner as seen from p: where it lies beside the ray from the light to p, and its depth.
vec3 shadowDepthMapCorner(int texel, int face, vec2 base, vec2 perDepth)
{
  vec3 v = texelFetch(shadowDepthMapCorners, texel).xyz;
#ifdef SHADOW_DEPTH_MAP_CUBES
  if (face >= 0)
  {
    vec3 r = face < 2 ? v.yzx : face < 4 ? v.zxy : v;
    float way = (face & 1) == 0 ? 1.0 : -1.0;
    v = vec3(-way * r.x, r.y, way * r.z);
  }
#endif
  return vec3(v.xy - base - perDepth * v.z, v.z);
}

struct ShadowDepthMapRay
{
  int face;
  vec2 base;     // where it is at the depth 0 of the list
  vec2 perDepth; // and how it moves from there
  float depth;   // of the receiver, less its slack
};

// The depth of a triangle's plane where the ray meets it.
float shadowDepthMapPlane(ShadowDepthMapRay ray, uint number)
{
  int texel = 3 * int(number - 1u);
  vec3 a = shadowDepthMapCorner(texel, ray.face, ray.base, ray.perDepth);
  vec3 b = shadowDepthMapCorner(texel + 1, ray.face, ray.base, ray.perDepth);
  vec3 c = shadowDepthMapCorner(texel + 2, ray.face, ray.base, ray.perDepth);
  vec3 weight = vec3(
    shadowDepthMapCross(b.xy, c.xy), shadowDepthMapCross(c.xy, a.xy), shadowDepthMapCross(a.xy, b.xy));
  return dot(weight, vec3(a.z, b.z, c.z)) / (weight.x + weight.y + weight.z);
}

// Whether the surface of triangle `number`, seen `start` beside the ray, reaches the ray ahead of the receiver.
bool shadowDepthMapWalk(ShadowDepthMapRay ray, uint number, vec2 start)
{
  for (int walked = 0; walked < shadowDepthMapMostSteps; ++walked)
  {
    int texel = 3 * int(number - 1u);
    vec3 a = shadowDepthMapCorner(texel, ray.face, ray.base, ray.perDepth);
    vec3 b = shadowDepthMapCorner(texel + 1, ray.face, ray.base, ray.perDepth);
    vec3 c = shadowDepthMapCorner(texel + 2, ray.face, ray.base, ray.perDepth);

    // On which side of each side the ray passes; to a rounding, on it is within.
    vec3 weight = vec3(
      shadowDepthMapCross(b.xy, c.xy), shadowDepthMapCross(c.xy, a.xy), shadowDepthMapCross(a.xy, b.xy));
    vec3 size = abs(a) + abs(b) + abs(c);
    float rounding = 2.4e-7 * size.x * size.y;
    if (min(min(weight.x, weight.y), weight.z) >= -rounding)
    {
      float area = weight.x + weight.y + weight.z;
      return area > 0.0 && dot(weight, vec3(a.z, b.z, c.z)) < ray.depth * area;
    }

    // Left or right of the way from the start to the ray.
    vec3 left = vec3(
      shadowDepthMapCross(a.xy, start), shadowDepthMapCross(b.xy, start), shadowDepthMapCross(c.xy, start));
    bvec3 isLeft = greaterThanEqual(left, vec3(0.0));
    if (walked == 0 && (all(isLeft) || !any(isLeft)))
    {
      // Rounded beside it: begin in its middle.
      start = (a.xy + b.xy + c.xy) / 3.0;
      left = vec3(
        shadowDepthMapCross(a.xy, start), shadowDepthMapCross(b.xy, start), shadowDepthMapCross(c.xy, start));
      isLeft = greaterThanEqual(left, vec3(0.0));
    }
    // Counter-clockwise, the way leaves where the border goes from its right to its left.
    int side = !isLeft.x && isLeft.y ? 0 : !isLeft.y && isLeft.z ? 1 : !isLeft.z && isLeft.x ? 2 : 3;
    number = side < 3 ? texelFetch(shadowDepthMapNeighbours, texel + side).w : 0u;
    if (number == 0u)
    {
      return false;
    }
  }
  return false;
}

float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  vec2 corner = shadowDepthMapCornerAt(p.xy);
  vec2 f = p.xy + 0.5 - corner;
  vec4 depth = shadowDepthMapGather(layer, corner);

  // The receiver's plane at the four centres, without the share of a texel that p is less by.
  vec4 other = shadowDepthMapOthers[layer];
  vec4 depths = shadowDepthMapDepths[layer];
  bool parallel = depths.w == 0.0;
  float share = parallel ? other.z : other.z * max(depths.w - p.z * depths.y, 0.0) / (depths.w * depths.z);
  float z = p.z + share - min(shadowDepthMapSnap * (abs(slope.x) + abs(slope.y)), 1.0);
  float atCorner = z - dot(slope, f);
  vec4 receiver =
    vec4(atCorner + slope.y, atCorner + slope.x + slope.y, atCorner + slope.x, atCorner);
  bvec4 hides = lessThan(depth, min(receiver, 1.0));
  if (!any(hides))
  {
    return 1.0;
  }

  ivec2 low = ivec2(corner) - 1;
  uvec4 number = uvec4(texelFetch(shadowDepthMapNumbers, ivec3(low + ivec2(0, 1), layer), 0).r,
    texelFetch(shadowDepthMapNumbers, ivec3(low + ivec2(1, 1), layer), 0).r,
    texelFetch(shadowDepthMapNumbers, ivec3(low + ivec2(1, 0), layer), 0).r,
    texelFetch(shadowDepthMapNumbers, ivec3(low, layer), 0).r);
  if (dot(vec4(hides), vec4(equal(number, uvec4(0u)))) > 0.0)
  {
    // Nothing but a depth is known of what hides it.
    return shadowDepthMapBlend(depth, p, slope, f);
  }

  vec4 plane = shadowDepthMapPlanes[layer];
  vec2 there = (p.xy - plane.xy) * plane.zw;
  float reach = z * depths.y;
  ShadowDepthMapRay ray;
  ray.face = int(other.x);
  ray.base = parallel ? there : there * other.y;
  ray.perDepth = parallel ? vec2(0.0) : there;
  ray.depth = z >= 1.0 ? 3.0e38 : depths.x + (parallel ? reach : depths.z * reach / (depths.w - reach));

  // The nearest texel first.
  ivec4 order = f.x < 0.5 ? (f.y < 0.5 ? ivec4(3, 2, 0, 1) : ivec4(0, 1, 3, 2))
                          : (f.y < 0.5 ? ivec4(2, 3, 1, 0) : ivec4(1, 0, 2, 3));
  for (int i = 0; i < 4; ++i)
  {
    int texel = order[i];
    vec2 centre = vec2(texel == 1 || texel == 2 ? 1.0 : 0.0, texel < 2 ? 1.0 : 0.0);
    if (hides[texel] && shadowDepthMapWalk(ray, number[texel], (centre - f) * plane.zw))
    {
      return 0.0;
    }
  }

  // No surface reaches it that was seen. Where all four hide it, and go on to do so, one may be too thin to
  // have been.
  if (all(hides))
  {
    vec4 beyond = vec4(shadowDepthMapPlane(ray, number.x), shadowDepthMapPlane(ray, number.y),
      shadowDepthMapPlane(ray, number.z), shadowDepthMapPlane(ray, number.w));
    return all(lessThan(beyond, vec4(ray.depth))) ? 0.0 : 1.0;
  }
  return 1.0;
}
