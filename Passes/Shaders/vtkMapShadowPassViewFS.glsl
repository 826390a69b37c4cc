//VTK::System::Dec
// What the maps of a light hold and how fine they are, over the frame: see vtkShadowPass::SetDebugView. VC is the
// eye's view coordinates.
//VTK::Output::Dec

uniform sampler2DArray shadowReceivers; // position VC, and above 0 where there is a receiver
uniform sampler2DArray shadowMaps;
uniform vec2 shadowViewOrigin; // of the viewport in its framebuffer, pixels
uniform vec2 shadowViewScale;  // pixels of the receivers in one of the framebuffer
uniform vec2 shadowViewSize;   // pixels of the receivers
uniform int shadowView;        // 0 cascades, 1 texel-density, 2 map, 3 lit-part

const int Most = 8;
uniform int shadowNumberOfMaps;
uniform mat4 shadowMapFromView[Most]; // to texels
uniform vec4 shadowMapSize[Most];     // its width and height in texels, its layer, and the cascade's colour
// The inverse square of the distance from the eye up to which it is looked up, 0: any; and what its depths follow
// from in a perspective map, clip = x * view + y, or y = 0.
uniform vec3 shadowMapReach[Most];
uniform vec3 shadowEye;   // VC; what distances are from
uniform float shadowBlend; // share of a reach over which a cascade blends into the next

// Okabe and Ito 2008, without black.
const vec3 colors[8] = vec3[8](vec3(0.9, 0.6, 0.0), vec3(0.35, 0.7, 0.9), vec3(0.0, 0.62, 0.45),
  vec3(0.95, 0.9, 0.25), vec3(0.0, 0.45, 0.7), vec3(0.84, 0.37, 0.0), vec3(0.8, 0.6, 0.7), vec3(0.6));

vec4 receiverAt(ivec2 pixel)
{
  ivec2 inside = clamp(pixel, ivec2(0), ivec2(shadowViewSize) - 1);
  return texelFetch(shadowReceivers, ivec3(inside, 0), 0);
}

// Texels in map i; false behind the light.
bool toMap(int i, vec3 positionVC, out vec2 texel)
{
  vec4 q = shadowMapFromView[i] * vec4(positionVC, 1.0);
  texel = q.xy / q.w;
  return q.w > 0.0;
}

bool covers(int i, vec3 positionVC)
{
  vec2 texel;
  return toMap(i, positionVC, texel) && all(greaterThanEqual(texel, vec2(0.0))) &&
    all(lessThanEqual(texel, shadowMapSize[i].xy));
}

float shareOfReach(int i, vec3 positionVC)
{
  vec3 away = positionVC - shadowEye;
  return dot(away, away) * shadowMapReach[i].x;
}

// The map that a receiver is looked up in; Most: none.
int mapOf(vec3 positionVC)
{
  for (int i = 0; i < shadowNumberOfMaps; ++i)
  {
    if (shareOfReach(i, positionVC) <= 1.0 && covers(i, positionVC))
    {
      return i;
    }
  }
  return Most;
}

// How texels change from a pixel to its neighbour, whichever of the two lies nearer: an edge may lie between.
vec2 texelsAlong(int i, ivec2 pixel, ivec2 step, vec3 positionVC, vec2 texel)
{
  vec4 before = receiverAt(pixel - step), after = receiverAt(pixel + step);
  bool isBefore = after.w < 0.5 ||
    (before.w > 0.5 && distance(before.xyz, positionVC) < distance(after.xyz, positionVC));
  vec2 other;
  toMap(i, isBefore ? before.xyz : after.xyz, other);
  return isBefore ? texel - other : other - texel;
}

// Texels to a pixel, in the direction in which they are fewest: the smaller singular value of their change.
float texelDensity(int i, ivec2 pixel, vec3 positionVC)
{
  vec2 texel;
  toMap(i, positionVC, texel);
  vec2 a = texelsAlong(i, pixel, ivec2(1, 0), positionVC, texel);
  vec2 b = texelsAlong(i, pixel, ivec2(0, 1), positionVC, texel);
  float squares = dot(a, a) + dot(b, b), area = abs(a.x * b.y - a.y * b.x);
  float larger = sqrt(0.5 * (squares + sqrt(max(squares * squares - 4.0 * area * area, 0.0))));
  return larger > 0.0 ? area / larger : 0.0;
}

// Red: 16 pixels a texel, pale: one, blue: 16 texels a pixel; after the scale RdYlBu of Brewer 2003.
vec3 densityColor(float density)
{
  float steps = clamp(log2(max(density, 1.0e-9)) / 4.0, -1.0, 1.0);
  return steps < 0.0 ? mix(vec3(1.0, 1.0, 0.75), vec3(0.84, 0.1, 0.11), -steps)
                     : mix(vec3(1.0, 1.0, 0.75), vec3(0.17, 0.35, 0.75), steps);
}

// In a perspective map depths are of the inverse of the distance; made linear here.
float linearDepth(int i, float depth)
{
  vec2 clip = shadowMapReach[i].yz;
  return clip.y != 0.0 ? clip.y / (2.0 * depth - 1.0 + clip.x) : depth;
}

float storedDepth(int i, ivec2 texel)
{
  return texelFetch(shadowMaps, ivec3(texel, shadowMapSize[i].z), 0).r;
}

// Grey between the nearest and the farthest of some depths of the map, so that shapes are seen; white where
// nothing was drawn.
vec3 depthColor(int i, ivec2 texel)
{
  const int samples = 12;
  float near = 1.0, far = 0.0;
  for (int n = 0; n < samples * samples; ++n)
  {
    vec2 place = (vec2(n % samples, n / samples) + 0.5) / float(samples);
    float depth = storedDepth(i, ivec2(place * shadowMapSize[i].xy));
    near = min(near, depth);
    far = depth < 1.0 ? max(far, depth) : far;
  }
  float depth = storedDepth(i, texel);
  float start = linearDepth(i, near), end = linearDepth(i, far);
  float grey = far > near ? (linearDepth(i, depth) - start) / (end - start) : 0.5;
  return depth < 1.0 ? vec3(0.85 * clamp(grey, 0.0, 1.0)) : vec3(1.0);
}

// The maps side by side from the lower left, a rim in the map's colour.
vec4 mapTile(ivec2 pixel)
{
  int side = int(0.3 * min(shadowViewSize.x, shadowViewSize.y));
  int columns = max(int(shadowViewSize.x) / max(side, 1), 1);
  ivec2 tile = pixel / max(side, 1);
  int i = tile.x < columns ? tile.y * columns + tile.x : Most;
  if (i >= shadowNumberOfMaps)
  {
    return vec4(0.0);
  }
  ivec2 inTile = pixel - tile * side;
  vec2 size = shadowMapSize[i].xy;
  vec2 texel = (vec2(inTile) + 0.5) * max(size.x, size.y) / float(side);
  if (any(lessThan(inTile, ivec2(2))) || any(greaterThanEqual(inTile, ivec2(side - 2))))
  {
    return vec4(colors[int(shadowMapSize[i].w)], 1.0);
  }
  if (any(greaterThanEqual(texel, size)))
  {
    return vec4(0.0, 0.0, 0.0, 1.0);
  }
  return vec4(depthColor(i, ivec2(texel)), 1.0);
}

// The part of the scene that each map covers, the finest in front; its border as a line; no map: dark.
vec4 litPart(ivec2 pixel, vec3 positionVC)
{
  vec4 right = receiverAt(pixel + ivec2(1, 0)), above = receiverAt(pixel + ivec2(0, 1));
  vec4 color = vec4(0.0, 0.0, 0.0, 0.5);
  for (int i = shadowNumberOfMaps - 1; i >= 0; --i)
  {
    vec3 own = colors[int(shadowMapSize[i].w)];
    bool isCovered = covers(i, positionVC);
    color = isCovered ? vec4(own, 0.35) : color;
    bool isBorder = (right.w > 0.5 && covers(i, right.xyz) != isCovered) ||
      (above.w > 0.5 && covers(i, above.xyz) != isCovered);
    color = isBorder ? vec4(own, 1.0) : color;
  }
  return color;
}

void main()
{
  ivec2 pixel = ivec2((gl_FragCoord.xy - shadowViewOrigin) * shadowViewScale);
  if (shadowView == 2)
  {
    vec4 tile = mapTile(pixel);
    if (tile.a == 0.0)
    {
      discard;
    }
    gl_FragData[0] = tile;
    return;
  }
  vec4 receiver = receiverAt(pixel);
  if (receiver.w < 0.5)
  {
    discard;
  }
  if (shadowView == 3)
  {
    gl_FragData[0] = litPart(pixel, receiver.xyz);
    return;
  }
  int map = mapOf(receiver.xyz);
  if (map == Most)
  {
    discard;
  }
  if (shadowView == 1)
  {
    gl_FragData[0] = vec4(densityColor(texelDensity(map, pixel, receiver.xyz)), 0.8);
    return;
  }
  float start = (1.0 - shadowBlend) * (1.0 - shadowBlend);
  float next = start < 1.0 ? clamp((shareOfReach(map, receiver.xyz) - start) / (1.0 - start), 0.0, 1.0) : 0.0;
  int after = min(map + 1, shadowNumberOfMaps - 1);
  gl_FragData[0] =
    vec4(mix(colors[int(shadowMapSize[map].w)], colors[int(shadowMapSize[after].w)], next), 0.5);
}
