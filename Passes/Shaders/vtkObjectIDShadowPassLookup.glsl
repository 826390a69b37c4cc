// Visibility by object-ID map: what the light sees in the texels around the receiver, the receiver's own object or
// another one, and how far away that is. SHADOW_OBJECT is the receiver's ID; SHADOW_OBJECT_BITS and _STEPS as in
// vtkObjectIDShadowPassCasterFS.glsl; SHADOW_OBJECT_TAPS squared texels are tested.

#if SHADOW_OBJECT_BITS == 32
uniform sampler2DArray shadowObjectMaps;
#else
uniform usampler2DArray shadowObjectMaps;
#endif

struct shadowObjectTexels
{
  ivec4 ids;
  vec4 ways; // within the ranges of these IDs
};

// The texels (0,1), (1,1), (1,0), (0,0) beside the corner at `corner` (in texels).
shadowObjectTexels shadowObjectMapGather(int layer, vec2 corner)
{
  shadowObjectTexels texels;
#if SHADOW_OBJECT_BITS < 32 && defined(GL_ARB_texture_gather)
  const vec2 perTexel = 1.0 / vec2(SHADOW_OBJECT_MAP_WIDTH, SHADOW_OBJECT_MAP_HEIGHT);
  uvec4 codes = textureGather(shadowObjectMaps, vec3(corner * perTexel, float(layer)));
#else
  const ivec2 last = ivec2(SHADOW_OBJECT_MAP_WIDTH, SHADOW_OBJECT_MAP_HEIGHT) - 1;
  ivec2 high = clamp(ivec2(corner), ivec2(0), last);
  ivec2 low = clamp(ivec2(corner) - 1, ivec2(0), last);
#if SHADOW_OBJECT_BITS == 32
  vec2 a = texelFetch(shadowObjectMaps, ivec3(low.x, high.y, layer), 0).rg;
  vec2 b = texelFetch(shadowObjectMaps, ivec3(high, layer), 0).rg;
  vec2 c = texelFetch(shadowObjectMaps, ivec3(high.x, low.y, layer), 0).rg;
  vec2 d = texelFetch(shadowObjectMaps, ivec3(low, layer), 0).rg;
  texels.ids = ivec4(a.x, b.x, c.x, d.x);
  texels.ways = vec4(a.y, b.y, c.y, d.y);
#else
  uvec4 codes = uvec4(texelFetch(shadowObjectMaps, ivec3(low.x, high.y, layer), 0).r,
    texelFetch(shadowObjectMaps, ivec3(high, layer), 0).r,
    texelFetch(shadowObjectMaps, ivec3(high.x, low.y, layer), 0).r,
    texelFetch(shadowObjectMaps, ivec3(low, layer), 0).r);
#endif
#endif
#if SHADOW_OBJECT_BITS == 0
  texels.ids = ivec4(codes);
  texels.ways = vec4(0.0);
#elif SHADOW_OBJECT_BITS < 32
  texels.ids = ivec4(codes >> SHADOW_OBJECT_BITS);
  texels.ways = vec4(codes & uint(SHADOW_OBJECT_STEPS)) / float(SHADOW_OBJECT_STEPS);
#endif
  return texels;
}

// The same, as depths of the map. Without stored depths: the nearest of each object.
vec4 shadowObjectMapDepths(int layer, shadowObjectTexels texels)
{
  vec3 a = shadowObjectRange(layer, texels.ids.x), b = shadowObjectRange(layer, texels.ids.y);
  vec3 c = shadowObjectRange(layer, texels.ids.z), d = shadowObjectRange(layer, texels.ids.w);
  vec4 nearest = vec4(a.x, b.x, c.x, d.x);
#if SHADOW_OBJECT_BITS == 0
  return nearest;
#else
  vec4 way = texels.ways;
  vec4 share = way / (way + vec4(a.z, b.z, c.z, d.z) * (1.0 - way));
  return nearest + vec4(a.y, b.y, c.y, d.y) * share;
#endif
}

// The four texels around p, tested at their own centres.
float shadowObjectMapTest(int layer, vec3 p, vec2 slope)
{
  vec2 corner = shadowObjectMapCorner(p.xy);
  vec2 f = p.xy + 0.5 - corner;
  shadowObjectTexels texels = shadowObjectMapGather(layer, corner);
  vec4 depth = shadowObjectMapDepths(layer, texels);
#if SHADOW_OBJECT_TAPS == 1
  vec2 weight = step(0.5, f);
#else
  vec2 weight = f;
#endif
  vec4 lit = step(shadowObjectMapPlane(p, slope, f), depth);
#if SHADOW_OBJECT_BITS == 0
  // Lit where any of them shows the receiver's own object: in shadow where all agree.
  lit = max(lit, vec4(equal(texels.ids, ivec4(SHADOW_OBJECT))));
  return shadowObjectMapBlend(lit, weight) > 0.0 ? 1.0 : 0.0;
#else
  return shadowObjectMapIsOnSurface(depth, p, slope, f) ? 1.0 : shadowObjectMapBlend(lit, weight);
#endif
}

float shadowObjectMapCompare(int layer, vec3 p, vec2 slope)
{
  // A depth that was put together from a range has roundings more, up to four times half the last place of 1.
  p.z -= 2.3841858e-7;
#if SHADOW_OBJECT_TAPS <= 2
  return shadowObjectMapTest(layer, p, slope);
#else
  // N x N texels are four each, N - 1 times along and across, a texel apart.
  const int tests = SHADOW_OBJECT_TAPS - 1;
  float most = 0.0, sum = 0.0;
  for (int i = 0; i < tests * tests; ++i)
  {
    vec2 beside = vec2(i % tests, i / tests) - 0.5 * float(tests - 1);
    float visibility =
      shadowObjectMapTest(layer, p + vec3(beside, dot(slope, beside)), slope);
    most = max(most, visibility);
    sum += visibility;
  }
  return SHADOW_OBJECT_BITS == 0 ? most : sum / float(tests * tests);
#endif
}
