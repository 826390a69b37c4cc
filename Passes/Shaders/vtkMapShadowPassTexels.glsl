// A receiver's plane among the four texels around it. Like vtkMapShadowPassLookup.glsl, this text is written into
// a shader once for each technique by maps, ahead of the technique's own comparison.
//
// p: texels, and depth less the bound of its rounding; slope: of the receiver's plane, in depth per texel. The four
// texels, and what is worked out for them, are in textureGather's order: (0,1), (1,1), (1,0), (0,0) beside a corner.

// The corner between the four texels. Off the map nothing casts; one texel that stays in the cache stands for all
// of that.
vec2 shadowMapCorner(vec2 p)
{
  const vec2 middle = 0.5 * vec2(SHADOW_MAP_WIDTH, SHADOW_MAP_HEIGHT);
  vec2 beyond = abs(p - middle) - middle;
  return max(beyond.x, beyond.y) <= 0.0 ? floor(p + 0.5) : vec2(0.0);
}

float shadowMapRise(vec2 slope)
{
  return abs(slope.x) + abs(slope.y);
}

// Half a texel of slope for what the rasteriser did not put exactly at the texel's centre.
float shadowMapSlack(vec2 slope)
{
  return min(0.5 * shadowMapRise(slope), 1.0);
}

// The receiver's plane at the four centres, less the slack; beyond the farthest caster there is nothing but what was
// cleared to 1. f: from the centre of texel (0,0) to the receiver.
vec4 shadowMapPlane(vec3 p, vec2 slope, vec2 f)
{
  float z = p.z - shadowMapSlack(slope) - dot(slope, f);
  return min(vec4(z + slope.y, z + slope.x + slope.y, z + slope.x, z), 1.0);
}

float shadowMapBlend(vec4 texels, vec2 f)
{
  return mix(mix(texels.w, texels.z, f.x), mix(texels.x, texels.y, f.x), f.y);
}

// Where a surface curves, its plane leaves it beside the receiver. If the four depths lie no farther apart than those
// of one surface, up to four times as steep as the receiver, they are of one: what is not behind it is lit.
bool shadowMapIsOnSurface(vec4 depth, vec3 p, vec2 slope, vec2 f)
{
  float nearest = min(min(depth.x, depth.y), min(depth.z, depth.w));
  float farthest = max(max(depth.x, depth.y), max(depth.z, depth.w));
  return farthest - nearest <= 4.0 * shadowMapRise(slope) &&
    p.z - shadowMapSlack(slope) <= shadowMapBlend(depth, f);
}

// The direction of a disc's next tap: turned by the golden angle (Vogel 1979), without its cosine and sine for each tap.
vec2 shadowMapTurned(vec2 way)
{
  const vec2 golden = vec2(-0.73736888, 0.67549029); // cosine and sine
  return vec2(way.x * golden.x - way.y * golden.y, way.x * golden.y + way.y * golden.x);
}

// 0 to less than 1, the same for a pixel in every frame, and spread evenly over those around it: J. Jimenez 2014.
float shadowMapNoise()
{
  return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}
