// Visibility of lights with a radius, as the mean over sample lights; a function for each kind of view. Ahead of it
// stand SHADOW_SAMPLED_LIGHTS, how many there are, and
//   float shadowSampledMapFourTexels(int layer, vec3 p, vec2 slope)

// Of each light: where its faces begin in the rows, where its places do, and how many samples it has.
uniform vec4 shadowSampledLights[SHADOW_SAMPLED_LIGHTS];

// Two a face: texels per tangent and the texel of tangent 0; then depth = x + y / (depth before the light), the
// layer of its first sample (less than 0: nothing casts here) and layers a sample. Directional: positions
// instead of tangents, and depth = x + y * position. Else in units as in shadowMapPlace.
// And one a place: where the sample stands, as seen from the light's middle; directional: how far its rays lean.
uniform samplerBuffer shadowSampledRows;

// In all of these, q: as seen from the light's middle, in its axes; w above 0: lit everywhere; normal: of the
// receiver's plane.
float shadowSampledParallel(int light, vec4 q, vec3 normal)
{
  if (q.w > 0.0)
  {
    return 1.0;
  }
  vec4 lamp = shadowSampledLights[light];
  int first = int(lamp.y), samples = int(lamp.z);
  vec4 scale = texelFetch(shadowSampledRows, int(lamp.x));
  vec4 depth = texelFetch(shadowSampledRows, int(lamp.x) + 1);
  vec2 middle = scale.xy * q.xy + scale.zw;
  float z = depth.x + depth.y * q.z, sum = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    vec2 lean = texelFetch(shadowSampledRows, first + i).xy;
    float along = normal.z - dot(normal.xy, lean);
    vec2 slope = along != 0.0 ? -depth.y * normal.xy / (along * scale.xy) : vec2(0.0);
    vec3 p = vec3(middle + scale.xy * (lean * q.z), z);
    sum += shadowSampledMapFourTexels(int(depth.z) + i * int(depth.w), p, slope);
  }
  return sum / float(samples);
}

// One sample, by a face that it sees r in: to the right, up and ahead. n.r = h is the receiver's plane.
float shadowSampledFace(vec4 scale, vec4 depth, int i, vec3 r, vec3 n, float h)
{
  if (depth.z < 0.0 || r.z <= 0.0)
  {
    return 1.0;
  }
  float inverse = 1.0 / r.z;
  vec3 p = vec3(scale.xy * r.xy * inverse + scale.zw,
    depth.x + depth.y * (inverse + inverse * inverse * 5.9604645e-7));
  // On the plane the inverse of the depth is linear in the tangents.
  vec2 slope = h != 0.0 ? depth.y * n.xy / (h * scale.xy) : vec2(0.0);
  return shadowSampledMapFourTexels(int(depth.z) + i * int(depth.w), p, slope);
}

float shadowSampledView(int light, vec4 q, vec3 normal)
{
  if (q.w > 0.0)
  {
    return 1.0;
  }
  vec4 lamp = shadowSampledLights[light];
  int first = int(lamp.y), samples = int(lamp.z);
  vec4 scale = texelFetch(shadowSampledRows, int(lamp.x));
  vec4 depth = texelFetch(shadowSampledRows, int(lamp.x) + 1);
  const vec3 ahead = vec3(1.0, 1.0, -1.0);
  float h = dot(normal, q.xyz), sum = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    vec3 place = texelFetch(shadowSampledRows, first + i).xyz;
    sum += shadowSampledFace(
      scale, depth, i, ahead * (q.xyz - place), ahead * normal, h - dot(normal, place));
  }
  return sum / float(samples);
}

float shadowSampledCube(int light, vec4 q, vec3 normal)
{
  if (q.w > 0.0)
  {
    return 1.0;
  }
  vec4 lamp = shadowSampledLights[light];
  int first = int(lamp.y), samples = int(lamp.z);
  float h = dot(normal, q.xyz), sum = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    vec3 place = texelFetch(shadowSampledRows, first + i).xyz;
    vec3 r = q.xyz - place;
    // The faces of a cube as Core/LightView.h has them.
    vec3 reach = abs(r);
    bool isX = reach.x >= max(reach.y, reach.z);
    bool isY = !isX && reach.y >= reach.z;
    vec3 c = isX ? r.yzx : isY ? r.zxy : r;
    vec3 n = isX ? normal.yzx : isY ? normal.zxy : normal;
    vec3 way = c.z < 0.0 ? vec3(1.0, 1.0, -1.0) : vec3(-1.0, 1.0, 1.0);
    int row = int(lamp.x) + 2 * ((isX ? 0 : isY ? 2 : 4) + (c.z < 0.0 ? 1 : 0));
    sum += shadowSampledFace(texelFetch(shadowSampledRows, row),
      texelFetch(shadowSampledRows, row + 1), i, way * c, way * n, h - dot(normal, place));
  }
  return sum / float(samples);
}

float shadowSampledParallel(int light, vec4 q)
{
  return shadowSampledParallel(light, q, cross(dFdx(q.xyz), dFdy(q.xyz)));
}

float shadowSampledView(int light, vec4 q)
{
  return shadowSampledView(light, q, cross(dFdx(q.xyz), dFdy(q.xyz)));
}

float shadowSampledCube(int light, vec4 q)
{
  return shadowSampledCube(light, q, cross(dFdx(q.xyz), dFdy(q.xyz)));
}

float shadowSampledParallel(int light, vec4 q, vec4 dq1, vec4 dq2)
{
  return shadowSampledParallel(light, q, cross(dq1.xyz, dq2.xyz));
}

float shadowSampledView(int light, vec4 q, vec4 dq1, vec4 dq2)
{
  return shadowSampledView(light, q, cross(dq1.xyz, dq2.xyz));
}

float shadowSampledCube(int light, vec4 q, vec4 dq1, vec4 dq2)
{
  return shadowSampledCube(light, q, cross(dq1.xyz, dq2.xyz));
}
