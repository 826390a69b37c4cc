// A caster's texel: its ID, and its depth within its own range. SHADOW_OBJECT is the ID, and
// SHADOW_OBJECT_STEPS the largest depth that is stored (0: none is), of SHADOW_OBJECT_BITS bits. A triangle in whose
// plane a lamp lies may have no depth: it is drawn as nothing.

uniform int shadowObjectLayer;

float shadowObjectWayInRange(float depth)
{
  vec3 range = shadowObjectRange(shadowObjectLayer, SHADOW_OBJECT);
  float share = range.y > 0.0 ? clamp((depth - range.x) / range.y, 0.0, 1.0) : 0.0;
  return share * range.z / (1.0 - share + share * range.z);
}

#if SHADOW_OBJECT_BITS == 32
vec4 shadowObjectTexel(float depth)
{
  return isnan(depth) ? vec4(0.0) : vec4(float(SHADOW_OBJECT), shadowObjectWayInRange(depth), 0.0, 1.0);
}
#else
// Rounded away from the light, so that a surface does not shadow itself by its rounding.
uvec4 shadowObjectTexel(float depth)
{
  uint id = uint(SHADOW_OBJECT);
#if SHADOW_OBJECT_BITS > 0
  const float steps = float(SHADOW_OBJECT_STEPS);
  id = (id << SHADOW_OBJECT_BITS) | uint(min(ceil(shadowObjectWayInRange(depth) * steps), steps));
#endif
  return uvec4(isnan(depth) ? 0u : id);
}
#endif
