// What all filters of a depth map share: the depth that a receiver is held against texels with, and what lies
// beyond the map. Ahead of it stand
//   SHADOW_DEPTH_MAP_WIDTH, _HEIGHT   a layer's texels
//   SHADOW_DEPTH_MAP_LAYERS           layers that the arrays below have room for
//   SHADOW_DEPTH_MAP_QUANTUM          the step of the map's format, as depth, where it is more than a float's
//   SHADOW_DEPTH_MAP_STEP             if texels are steps of the distance from the light: how far a step reaches
//                                     beyond its texel, as a share of the way from the near plane to the far one
//   SHADOW_DEPTH_MAP_CONSTANT_BIAS, _SLOPE_BIAS   if the bias is the user's: depth, and depth per slope
//   SHADOW_DEPTH_MAP_REPEATS or _CLAMPS           if the map does so beyond its sides

// Of each layer: x texels that the light's disc spans, from its middle to its rim, per depth between blocker and
// receiver; y the most texels that a kernel may reach; z the near plane's distance over the far one's, 1 if the
// light is directional; w texels along the second side for one along the first. x and y count those of the side
// that has more.
uniform vec4 shadowDepthMapViews[SHADOW_DEPTH_MAP_LAYERS];

// Off the map nothing casts; one texel that stays in the cache stands for all of that.
bool shadowDepthMapHolds(vec2 p)
{
  const vec2 middle = 0.5 * vec2(SHADOW_DEPTH_MAP_WIDTH, SHADOW_DEPTH_MAP_HEIGHT);
  vec2 beyond = abs(p - middle) - middle;
  return max(beyond.x, beyond.y) <= 0.0;
}

#if defined(SHADOW_DEPTH_MAP_REPEATS) || defined(SHADOW_DEPTH_MAP_CLAMPS)
// Of each layer, low and high corner of its sides; none if high is not above low.
uniform vec4 shadowDepthMapSides[SHADOW_DEPTH_MAP_LAYERS];

vec2 shadowDepthMapWrapped(int layer, vec2 p)
{
  vec4 sides = shadowDepthMapSides[layer];
#ifdef SHADOW_DEPTH_MAP_REPEATS
  vec2 wrapped = sides.xy + mod(p - sides.xy, max(sides.zw - sides.xy, vec2(1.0)));
#else
  vec2 wrapped = clamp(p, sides.xy, max(sides.zw, sides.xy));
#endif
  return sides.z > sides.x ? wrapped : p;
}
#else
#define shadowDepthMapWrapped(layer, p) (p)
#endif

// What a receiver's depth is less by, and the slope of the plane that it is continued by to other texels. Half a
// texel of slope is for what the rasteriser did not put exactly at the texel's centre. With a bias of the user's
// it is one depth for all texels.
#ifdef SHADOW_DEPTH_MAP_CONSTANT_BIAS
float shadowDepthMapSlack(vec2 slope, float texels)
{
  return SHADOW_DEPTH_MAP_CONSTANT_BIAS +
    SHADOW_DEPTH_MAP_SLOPE_BIAS * max(abs(slope.x), abs(slope.y));
}
#define shadowDepthMapTilt(slope) vec2(0.0)
#else
float shadowDepthMapSlack(vec2 slope, float texels)
{
  return min(texels * shadowDepthMapRise(slope), 1.0) + SHADOW_DEPTH_MAP_QUANTUM;
}
#define shadowDepthMapTilt(slope) (slope)
#endif
