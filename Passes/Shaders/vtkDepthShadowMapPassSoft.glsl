// Filter "soft": percentage-closer soft shadows (R. Fernando 2005).
//
// Seen in the map, the rays from a receiver to the light's disc are a straight cone, of a perspective map, too:
// at the depth z its radius is views.x * (p.z - z) texels. Blockers are texels in that cone, before the
// receiver's plane. The similar triangles of a blocker, the receiver and the disc give the penumbra.
float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  vec4 view = shadowDepthMapViews[layer];
  float reach = min(view.x * p.z, view.y);
  if (reach < 0.5)
  {
    return shadowDepthMapFourTexels(layer, vec3(shadowDepthMapWrapped(layer, p.xy), p.z), slope);
  }

  vec2 turn = shadowDepthMapTurn();
  vec3 before = vec3(p.xy, p.z - shadowDepthMapSlack(slope, 0.5));
  vec2 plane = shadowDepthMapTilt(slope);
  float sum = 0.0, blockers = 0.0;
  for (int tap = 0; tap < SHADOW_DEPTH_MAP_TAPS; ++tap)
  {
    // Spread evenly over radii, for the cone is thin where blockers are near; each stands for its ring.
    float share;
    vec2 offset = reach * shadowDepthMapTap(tap, turn, share);
    offset *= share;
    vec4 receiver;
    vec2 f;
    vec4 depth = shadowDepthMapAround(layer, before, plane, offset, receiver, f);
    // A texel's width to spare, for the blocker's edge may lie anywhere in it.
    vec4 cone = vec4(before.z - (length(offset) - 1.0) / view.x);
    vec4 blocks = vec4(lessThan(depth, min(min(receiver, cone), 1.0)));
    sum += share * dot(blocks, depth);
    blockers += share * dot(blocks, vec4(1.0));
  }
  if (blockers == 0.0)
  {
    // What blocks may be nearer than the innermost tap can tell: then the shadow is hard.
    return shadowDepthMapFourTexels(layer, vec3(shadowDepthMapWrapped(layer, p.xy), p.z), slope);
  }
  float penumbra = clamp(view.x * (p.z - sum / blockers), 0.5, view.y);
  return shadowDepthMapKernel(layer, p, slope, penumbra, turn);
}
