// Visibility of lights with a radius, as the mean over sample lights. Ahead of it stand SHADOW_SAMPLED_LIGHTS,
// _FACES and _PLACES, how many there are of all lights, and
//   float shadowSampledMapFourTexels(int layer, vec3 p, vec2 slope)

// Of each light: its first place, its samples, its first face; w 0: directional, 1: one view, 6: a cube.
uniform vec4 shadowSampledLights[SHADOW_SAMPLED_LIGHTS];

// Two a face: texels per tangent and the texel of tangent 0; then depth = x + y / (depth before the light), the
// layer of its first sample (less than 0: nothing casts here) and layers a sample. Directional: positions
// instead of tangents, and depth = x + y * position. Else in units as in shadowMapPlace.
uniform vec4 shadowSampledFaces[2 * SHADOW_SAMPLED_FACES];

// Where each sample stands, as seen from the light's middle; directional: how far its rays lean.
uniform vec4 shadowSampledPlaces[SHADOW_SAMPLED_PLACES];

// One sample, by a face that it sees r in: to the right, up and ahead. n.r = h is the receiver's plane.
float shadowSampledView(int face, int i, vec3 r, vec3 n, float h)
{
  vec4 scale = shadowSampledFaces[2 * face], depth = shadowSampledFaces[2 * face + 1];
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

float shadowSampledParallel(int face, int i, vec3 q, vec3 normal, vec2 lean)
{
  vec4 scale = shadowSampledFaces[2 * face], depth = shadowSampledFaces[2 * face + 1];
  vec3 p = vec3(scale.xy * (q.xy + lean * q.z) + scale.zw, depth.x + depth.y * q.z);
  float along = normal.z - dot(normal.xy, lean);
  vec2 slope = along != 0.0 ? -depth.y * normal.xy / (along * scale.xy) : vec2(0.0);
  return shadowSampledMapFourTexels(int(depth.z) + i * int(depth.w), p, slope);
}

// q: as seen from the light's middle, in its axes; normal: of the receiver's plane.
float shadowSampledLight(int light, vec4 q, vec3 normal)
{
  if (q.w > 0.0)
  {
    return 1.0;
  }
  vec4 lamp = shadowSampledLights[light];
  int samples = int(lamp.y), face = int(lamp.z);
  float h = dot(normal, q.xyz), sum = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    vec3 place = shadowSampledPlaces[int(lamp.x) + i].xyz;
    vec3 r = q.xyz - place;
    float beyond = h - dot(normal, place);
    if (lamp.w == 0.0)
    {
      sum += shadowSampledParallel(face, i, q.xyz, normal, place.xy);
    }
    else if (lamp.w == 1.0)
    {
      sum += shadowSampledView(face, i, vec3(r.xy, -r.z), vec3(normal.xy, -normal.z), beyond);
    }
    else
    {
      // The faces of a cube as Core/LightView.h has them.
      vec3 reach = abs(r);
      bool isX = reach.x >= max(reach.y, reach.z);
      bool isY = !isX && reach.y >= reach.z;
      vec3 c = isX ? r.yzx : isY ? r.zxy : r;
      vec3 n = isX ? normal.yzx : isY ? normal.zxy : normal;
      vec3 way = c.z < 0.0 ? vec3(1.0, 1.0, -1.0) : vec3(-1.0, 1.0, 1.0);
      int side = (isX ? 0 : isY ? 2 : 4) + (c.z < 0.0 ? 1 : 0);
      sum += shadowSampledView(face + side, i, way * c, way * n, beyond);
    }
  }
  return sum / float(samples);
}

float shadowSampledLight(int light, vec4 q)
{
  return shadowSampledLight(light, q, cross(dFdx(q.xyz), dFdy(q.xyz)));
}

float shadowSampledLight(int light, vec4 q, vec4 dq1, vec4 dq2)
{
  return shadowSampledLight(light, q, cross(dq1.xyz, dq2.xyz));
}
