// Where the ray of a pixel meets the plane of a wide floor (see vtkShadowWideFloors.h), view coordinates. Positions
// that are interpolated between its corners are rounded as these are, by more than what stands on it is large.

// n.p = w, n of length 1; n = 0: no wide floor, though drawn by the same mapper as one.
uniform vec4 shadowFloorPlane;
// From gl_FragCoord.xy, a factor and an offset: the ray's x and y where it is 1 before the eye; of a parallel eye
// its place.
uniform vec4 shadowFloorRay;
// x: the eye is parallel; y and z: depth from the place's z, offset and factor of it (of 1 / z if not parallel).
uniform vec3 shadowFloorEye;

vec3 shadowFloorPlace()
{
  vec2 ray = gl_FragCoord.xy * shadowFloorRay.xy + shadowFloorRay.zw;
  vec3 n = shadowFloorPlane.xyz;
  return shadowFloorEye.x != 0.0 ? vec3(ray, (shadowFloorPlane.w - dot(n.xy, ray)) / n.z)
                                 : vec3(ray, -1.0) * (shadowFloorPlane.w / dot(n, vec3(ray, -1.0)));
}

// At the horizon a pixel that shows the floor may have a ray that misses it.
bool shadowFloorIsMet(float z)
{
  return shadowFloorPlane.xyz != vec3(0.0) && (shadowFloorEye.x != 0.0 || (z < 0.0 && z > -1.0e38));
}

vec4 shadowFloorPlace(vec4 vertexVC)
{
  vec3 place = shadowFloorPlace();
  return shadowFloorIsMet(place.z) ? vec4(place, 1.0) : vertexVC;
}

float shadowFloorDepth(float depth)
{
  float z = shadowFloorPlace().z;
  float placed = shadowFloorEye.y + shadowFloorEye.z * (shadowFloorEye.x != 0.0 ? z : 1.0 / z);
  return shadowFloorIsMet(z) ? clamp(placed, 0.0, 1.0) : depth;
}
