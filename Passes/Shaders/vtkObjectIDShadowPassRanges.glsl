// The depths of each object in each map: the nearest, and how far it reaches from there. ID 0 is where nothing was
// drawn: it lies at depth 1.

uniform samplerBuffer shadowObjectRanges;
uniform int shadowObjectRow; // IDs of a map

vec2 shadowObjectRange(int layer, int id)
{
  return texelFetch(shadowObjectRanges, layer * shadowObjectRow + id).rg;
}
