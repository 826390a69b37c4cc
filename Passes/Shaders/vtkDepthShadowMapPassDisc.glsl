// Filter "disc": percentage-closer filtering over a disc of SHADOW_DEPTH_MAP_RADIUS texels.
float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  return shadowDepthMapKernel(layer, p, slope, SHADOW_DEPTH_MAP_RADIUS, shadowDepthMapTurn());
}
