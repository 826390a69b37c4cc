// Filter "soft": soft shadows by depth, of a light with a radius.
//
// Seen in the map, the rays from a receiver to the light's disc are a straight cone, of a perspective map, too:
// at the depth z its radius is views.x * (p.z - z) texels. Blockers are texels in that cone, before the
// receiver's plane (R. Fernando 2005). Those of one depth hide the share of the cone's circle there that they
// cover; by its own circle each texel hides a share of the disc (G. Guennebaud et al. 2006).
//
// Blockers of several depths are taken in slabs, the one nearest to the light first. What a slab hides is told by
// those taps alone at which nothing nearer stands before it, and what all leave free is the product: the
// product-limit estimate of censored data (E. Kaplan, P. Meier 1958). With all blockers at one depth it is the
// mean over one kernel.
//
// Where texels have two sides, lengths are in the shorter one, of which there are more.
float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  vec4 view = shadowDepthMapViews[layer];
  float reach = min(view.x * p.z, view.y);
  if (reach < 0.5)
  {
    return shadowDepthMapFourTexels(layer, vec3(shadowDepthMapWrapped(layer, p.xy), p.z), slope);
  }

  // Much may lie in the cone of a wide light: then up to half as many taps again search, and up to three times as
  // many tell.
  float wide = clamp(reach / 64.0, 1.0, 3.0);
  int searching = int(float(SHADOW_DEPTH_MAP_TAPS) * min(wide, 1.5));
  int telling = int(float(SHADOW_DEPTH_MAP_TAPS) * wide);
  vec2 first = shadowDepthMapFirstTap(), way = first;
  vec2 texels = min(vec2(1.0 / view.w, view.w), 1.0); // for each of the lengths
  float texel = 1.0 / min(texels.x, texels.y);
  vec3 before = vec3(p.xy, p.z - shadowDepthMapSlack(slope, 0.5));
  vec2 plane = shadowDepthMapTilt(slope);
  vec4 nearest = vec4(1.0), farthest = vec4(0.0);
  for (int tap = 0; tap < searching; ++tap)
  {
    // The farther in, the closer: the cone is thin where blockers are near.
    float share = shadowDepthMapShare(tap, searching);
    float radius = reach * share * share;
    vec4 receiver;
    vec2 f;
    vec4 depth = shadowDepthMapAround(layer, before, plane, radius * way * texels, receiver, f);
    // A texel's width to spare, for the blocker's edge may lie anywhere in it.
    vec4 cone = vec4(before.z - (radius - texel) / view.x);
    vec4 blocks = vec4(lessThan(depth, min(min(receiver, cone), 1.0)));
    nearest = min(nearest, mix(vec4(1.0), depth, blocks));
    farthest = max(farthest, depth * blocks);
    way = shadowDepthMapTurned(way);
  }
  nearest.xy = min(nearest.xy, nearest.zw);
  farthest.xy = max(farthest.xy, farthest.zw);
  float low = min(nearest.x, nearest.y), high = max(farthest.x, farthest.y);
  if (low == 1.0)
  {
    // What blocks may be nearer than the innermost tap can tell: then the shadow is hard.
    return shadowDepthMapFourTexels(layer, vec3(shadowDepthMapWrapped(layer, p.xy), p.z), slope);
  }

  // The cone's radius where the slabs end, and in their middles, each as many times the next one's; the last reaches
  // to the receiver.
  float widest = clamp(view.x * (p.z - low), 0.5, view.y);
  float narrowest = clamp(view.x * (p.z - high), 0.5, view.y);
  const vec4 slabs = vec4(0.25, 0.5, 0.75, 1.0);
  vec4 ends = widest * pow(vec4(narrowest / widest), slabs);
  vec4 middles = widest * pow(vec4(narrowest / widest), slabs - 0.125);
  ends.w = 0.0;

  // Taps are spread evenly over the area where all slabs are alike, else the closer the farther in, each with its
  // ring's weight.
  float alike = narrowest / widest;
  vec4 blocked = vec4(0.0), open = vec4(0.0);
  way = first;
  for (int tap = 0; tap < telling; ++tap)
  {
    float share = shadowDepthMapShare(tap, telling), root = sqrt(share);
    float radius = mix(share * share, root, alike);
    float weight = radius * mix(2.0 * share, 0.5 / root, alike);
    radius *= widest;
    vec4 receiver;
    vec2 f;
    vec4 depth = shadowDepthMapAround(layer, before, plane, radius * way * texels, receiver, f);
    vec2 g = 1.0 - f;
    vec4 parts = vec4(g.x * f.y, f.x * f.y, f.x * g.y, g.x * g.y) *
      vec4(lessThan(depth, min(receiver, 1.0)));
    float part = dot(parts, vec4(1.0));
    float own = part > 0.0 ? view.x * (p.z - dot(parts, depth) / part) : -1.0;
    vec4 upTo = part * step(ends, vec4(own));
    own = clamp(own, 0.5, view.y);
    vec4 overOwn = middles / own;
    blocked += weight * clamp(own - radius + 0.5, 0.0, 1.0) * overOwn * overOwn *
      (upTo - vec4(0.0, upTo.xyz));
    open += weight * clamp(middles - radius + 0.5, 0.0, 1.0) * (1.0 - upTo);
    way = shadowDepthMapTurned(way);
  }
  vec4 told = open + blocked;
  vec4 free = mix(vec4(1.0), open / max(told, 1e-6), vec4(greaterThan(told, vec4(1e-6))));
  return free.x * free.y * free.z * free.w;
}
