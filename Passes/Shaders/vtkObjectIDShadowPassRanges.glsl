// The depths of each object in each map: the nearest, and how far it reaches from there; and its nearest distance
// over its farthest, 1 if the map is parallel. ID 0 is where nothing was drawn: it lies at depth 1. What is stored of a
// depth is its share of the way in distance, in which one step is as long as any: an object that begins at a lamp
// has all but one step of its depths beside that.

uniform samplerBuffer shadowObjectRanges;
uniform int shadowObjectRow; // IDs of a map

vec3 shadowObjectRange(int layer, int id)
{
  return texelFetch(shadowObjectRanges, layer * shadowObjectRow + id).rgb;
}
