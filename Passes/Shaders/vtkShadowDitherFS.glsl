// Screen-door transparency of a caster: whether a fragment of this opacity is there. The threshold is a hash of its
// place and depth (pcg3d of Jarzynski and Olano 2020), so that surfaces one behind the other let through
// independently (Enderton et al. 2010).
bool shadowHolds(float opacity)
{
  uvec3 v = uvec3(uvec2(gl_FragCoord.xy), uint(gl_FragCoord.z * 16777216.0));
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  return opacity > float(v.x >> 8u) / 16777216.0;
}
