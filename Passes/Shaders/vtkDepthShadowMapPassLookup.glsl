// Filter "percentage-closer".
// p: texels, and depth less the bound of its rounding; slope: of the receiver's plane, in depth per texel.
float shadowDepthMapCompare(int layer, vec3 p, vec2 slope)
{
  return shadowDepthMapFourTexels(layer, vec3(shadowDepthMapWrapped(layer, p.xy), p.z), slope);
}
