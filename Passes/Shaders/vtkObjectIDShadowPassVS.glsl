// Which object a vertex belongs to: by the table of its mesh, by its instance, or all of a draw to one.

uniform int shadowObjectFirst;    // number of the draw's object, or of its first instance's; below 0: none
uniform int shadowObjectPerInstance;
uniform int shadowObjectMost;     // IDs that there are: objects share them beyond
uniform int shadowObjectByVertex; // 1: the table tells
uniform samplerBuffer shadowObjectsOfVertices;

flat out int shadowObjectVSOutput;

int shadowObjectID()
{
  if (shadowObjectByVertex != 0)
  {
    return int(texelFetch(shadowObjectsOfVertices, gl_VertexID).r);
  }
  int object = shadowObjectFirst + shadowObjectPerInstance * gl_InstanceID;
  return object < 0 ? 0 : 1 + object % shadowObjectMost;
}
