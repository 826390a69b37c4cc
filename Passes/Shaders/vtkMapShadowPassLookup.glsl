// From a receiver's position to the maps of its light. This text is written into a shader once for each
// technique by maps, "shadowMap" and "SHADOW_MAP" replaced by names of the technique's own. Ahead of it stand
// SHADOW_MAP_WIDTH and _HEIGHT, a layer's texels (a uniform costs a software rasteriser as much as a texture
// fetch), and the technique's
//   float shadowMapCompare(int layer, vec3 p, vec2 slope)
// with p: texels, and depth less the bound of its rounding; slope: of the receiver's plane, in depth per texel.

// Depth change per texel on the receiver's plane; dx, dy: how a position in the map changes along two
// directions on it.
vec2 shadowMapSlope(vec3 dx, vec3 dy)
{
  float determinant = dx.x * dy.y - dx.y * dy.x;
  float inverse = determinant != 0.0 ? 1.0 / determinant : 0.0;
  return vec2(dy.y * dx.z - dx.y * dy.z, dx.x * dy.z - dy.x * dx.z) * inverse;
}

float shadowMapCompare(int layer, vec3 p, vec3 dx, vec3 dy)
{
  return shadowMapCompare(layer, p, shadowMapSlope(dx, dy));
}

float shadowMapParallel(int layer, vec4 q)
{
  return shadowMapCompare(layer, q.xyz, dFdx(q.xyz), dFdy(q.xyz));
}

float shadowMapParallel(int layer, vec4 q, vec4 dq1, vec4 dq2)
{
  return shadowMapCompare(layer, q.xyz, dq1.xyz, dq2.xyz);
}

// Of a perspective map q.z is less than the depth by q.w, and q.w is in units of the reach by which positions are
// rounded: see vtkShadowMapViews::ReceiverMap. A depth's error by the rounding of q.w, at most ten half units in
// the last place of 1, goes with its distance from 1, as the depth itself does.
vec3 shadowMapPlace(vec4 q)
{
  float inverse = 1.0 / q.w;
  vec3 p = q.xyz * inverse;
  return vec3(p.xy, 1.0 + (p.z + p.z * inverse * 5.9604645e-7));
}

// Behind a light nothing was drawn.
float shadowMapPerspective(int layer, vec4 q)
{
  vec3 p = shadowMapPlace(q);
  float visibility = shadowMapCompare(layer, p, dFdx(p), dFdy(p));
  return q.w > 0.0 ? visibility : 1.0;
}

float shadowMapPerspective(int layer, vec4 q, vec4 dq1, vec4 dq2)
{
  vec3 p = q.xyz / q.w;
  float visibility = shadowMapCompare(
    layer, shadowMapPlace(q), (dq1.xyz - p * dq1.w) / q.w, (dq2.xyz - p * dq2.w) / q.w);
  return q.w > 0.0 ? visibility : 1.0;
}

#if defined(SHADOW_MAP_CUBES) || defined(SHADOW_MAP_CASCADED_LIGHTS)
// Rows of four numbers, of which each pixel wants other ones: cubes' faces, then cascades. A software rasteriser
// fetches them by four here, and from uniforms one by one.
uniform samplerBuffer shadowMapRows;
#endif

#ifdef SHADOW_MAP_CUBES
// The six faces of each cube, a row each: depth = x + y / (depth before the light), z the layer, w texels per
// tangent. See Core/LightView.h for how they lie. Units as in shadowMapPlace.
// q: as seen from the light, in the cube's axes; normal: of the receiver's plane. Neither knows of faces, so
// that it does not matter what face a neighbour is on.
float shadowMapCube(int cube, vec4 q, vec3 normal)
{
  vec3 reach = abs(q.xyz);
  bool isX = reach.x >= max(reach.y, reach.z);
  bool isY = !isX && reach.y >= reach.z;
  vec3 r = isX ? q.yzx : isY ? q.zxy : q.xyz;
  vec2 n = isX ? normal.yz : isY ? normal.zx : normal.xy;
  vec4 face = texelFetch(shadowMapRows, 6 * cube + (isX ? 0 : isY ? 2 : 4) + (r.z < 0.0 ? 1 : 0));

  float inverse = 1.0 / r.z;
  float way = r.z < 0.0 ? -1.0 : 1.0;
  vec3 p = vec3(vec2(-face.w, face.w * way) * r.xy * inverse + 0.5 * float(SHADOW_MAP_HEIGHT),
    face.x + face.y * (abs(inverse) + inverse * inverse * 5.9604645e-7));

  // On the plane n.q = h the inverse of the depth is linear in the tangents.
  float h = dot(normal, q.xyz);
  vec2 slope = vec2(-way, 1.0) * n * (h != 0.0 ? face.y / (face.w * h) : 0.0);
  float visibility = shadowMapCompare(int(face.z), p, slope);
  return q.w > 0.0 ? 1.0 : visibility;
}

float shadowMapCube(int cube, vec4 q)
{
  return shadowMapCube(cube, q, cross(dFdx(q.xyz), dFdy(q.xyz)));
}

float shadowMapCube(int cube, vec4 q, vec4 dq1, vec4 dq2)
{
  return shadowMapCube(cube, q, cross(dq1.xyz, dq2.xyz));
}
#endif

#ifdef SHADOW_MAP_CASCADED_LIGHTS
// For each of SHADOW_MAP_CASCADES cascades of a light two: what is added in the map (texels, depth), and the
// layer; and what the position is multiplied by before.
#ifdef SHADOW_MAP_CUBES
const int shadowMapFirstCascade = 6 * SHADOW_MAP_CUBES;
#else
const int shadowMapFirstCascade = 0;
#endif
// And ahead of this text stands vec4 shadowMapReaches[], for each light one, or two if it has more than four
// cascades: squares of the reaches of its cascades, but the last's; infinite, as floats go, where there is none; and as
// the last number of all the cells of the grain to a unit of length.

int shadowMapBeyond(float square, vec3 ends)
{
  return int(square >= ends.x) + int(square >= ends.y) + int(square >= ends.z);
}

// 0 to less than 1, as if by chance. cells: of the grain, to a unit of length; the origin is a corner of one, and they
// are fixed in the world. By gl_FragCoord, as shadowMapNoise is, it would cost a software rasteriser a twentieth of the
// frame.
float shadowMapGrain(vec2 p, float cells)
{
  vec2 cell = fract(p * cells);
  return fract((cell.x + 1.7) * (cell.y + 2.3) * 7.3);
}

// q: in the light's axes, as seen from the eye: its length is the distance that a cascade is chosen by. slope: of
// the receiver's plane there. Where a cascade ends, over SHADOW_MAP_CASCADE_BLEND of its reach, it blends into
// the next, in grain: so each pixel is looked up once.
float shadowMapCascades(int light, vec4 q, vec2 slope)
{
  float square = dot(q.xyz, q.xyz);
#if SHADOW_MAP_CASCADES > 4
  vec4 reaches = shadowMapReaches[2 * light + 1];
#else
  vec4 reaches = shadowMapReaches[light];
#endif
#ifdef SHADOW_MAP_CASCADE_BLEND
  // The share of pixels that are looked up in the next one is linear in the square of the distance.
  const float start = (1.0 - SHADOW_MAP_CASCADE_BLEND) * (1.0 - SHADOW_MAP_CASCADE_BLEND);
  float end = 1.0 - shadowMapGrain(q.xy, reaches.w) * (1.0 - start);
#else
  const float end = 1.0;
#endif
  int beyond = shadowMapBeyond(square, end * reaches.xyz);
#if SHADOW_MAP_CASCADES > 4
  vec4 first = end * shadowMapReaches[2 * light];
  beyond += shadowMapBeyond(square, first.xyz) + int(square >= first.w);
#endif
  int row = shadowMapFirstCascade + 2 * (SHADOW_MAP_CASCADES * light + beyond);
  vec4 offset = texelFetch(shadowMapRows, row);
  vec3 scale = texelFetch(shadowMapRows, row + 1).xyz;
  float visibility =
    shadowMapCompare(int(offset.w), q.xyz * scale + offset.xyz, slope * scale.z / scale.xy);
  return q.w > 0.0 ? 1.0 : visibility;
}

float shadowMapCascades(int light, vec4 q)
{
  return shadowMapCascades(light, q, shadowMapSlope(dFdx(q.xyz), dFdy(q.xyz)));
}

float shadowMapCascades(int light, vec4 q, vec4 dq1, vec4 dq2)
{
  return shadowMapCascades(light, q, shadowMapSlope(dq1.xyz, dq2.xyz));
}
#endif
