// Taps over a disc of texels, for the filters "disc" and "soft". Ahead of it stands SHADOW_DEPTH_MAP_TAPS.
// H. Vogel 1979: points spread evenly over a disc, turned from pixel to pixel, so that their steps become grain.

// Direction of the first tap; each next one is by shadowDepthMapTurned.
vec2 shadowDepthMapFirstTap()
{
  float angle = 6.2831853 * shadowDepthMapNoise();
  return vec2(cos(angle), sin(angle));
}

// The share of so many taps within tap number `tap`.
float shadowDepthMapShare(int tap, int taps)
{
  return (float(tap) + 0.5) / float(taps);
}

// Depths around p.xy + offset, and the receiver's plane at their centres; the weights' share f.
vec4 shadowDepthMapAround(int layer, vec3 p, vec2 plane, vec2 offset, out vec4 receiver, out vec2 f)
{
  vec2 at = shadowDepthMapWrapped(layer, p.xy + offset);
  vec2 corner = shadowDepthMapCorner(at);
  f = at + 0.5 - corner;
  float z = p.z + dot(plane, offset - f);
  receiver = vec4(z + plane.y, z + plane.x + plane.y, z + plane.x, z);
  return shadowDepthMapGather(layer, corner);
}
