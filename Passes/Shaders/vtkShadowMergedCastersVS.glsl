//VTK::System::Dec
// A vertex of one of many casters, and the number of the matrix that takes it to the light's clip space.

in vec3 shadowVertex;
in uint shadowMatrix;
uniform samplerBuffer shadowMatrices; // column by column

vec4 shadowColumn(int column)
{
  return texelFetch(shadowMatrices, 4 * int(shadowMatrix) + column);
}

void main()
{
  gl_Position =
    mat4(shadowColumn(0), shadowColumn(1), shadowColumn(2), shadowColumn(3)) * vec4(shadowVertex, 1.0);
}
