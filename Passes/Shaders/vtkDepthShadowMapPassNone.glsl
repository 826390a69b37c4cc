// Filter "none": the one texel that holds the receiver, at its own centre.
float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  vec2 at = shadowDepthMapWrapped(layer, p.xy);
  ivec2 texel = shadowDepthMapHolds(at) ? ivec2(at) : ivec2(0);
  float depth = shadowDepthMapOfDistance(layer, texelFetch(shadowDepthMaps, ivec3(texel, layer), 0).rrrr).x;
  vec2 toCentre = vec2(texel) + 0.5 - at;
  float receiver = p.z - shadowDepthMapSlack(slope, 0.5) + dot(shadowDepthMapTilt(slope), toCentre);
  return step(min(receiver, 1.0), depth);
}
