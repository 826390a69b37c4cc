// Filter "disc": percentage-closer filtering, the mean over a disc of SHADOW_DEPTH_MAP_RADIUS texels.
float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  vec2 way = shadowDepthMapFirstTap();
  p.z -= shadowDepthMapSlack(slope, 0.5);
  vec2 plane = shadowDepthMapTilt(slope);
  float sum = 0.0;
  for (int tap = 0; tap < SHADOW_DEPTH_MAP_TAPS; ++tap)
  {
    vec4 receiver;
    vec2 f;
    vec2 offset = SHADOW_DEPTH_MAP_RADIUS * sqrt(shadowDepthMapShare(tap, SHADOW_DEPTH_MAP_TAPS)) * way;
    vec4 depth = shadowDepthMapAround(layer, p, plane, offset, receiver, f);
    vec4 lit = step(min(receiver, 1.0), depth);
    sum += shadowDepthMapBlend(lit, f);
    way = shadowDepthMapTurned(way);
  }
  return sum / float(SHADOW_DEPTH_MAP_TAPS);
}
