//VTK::System::Dec
// A triangle's corner in its light's space, and the triangle's number in the list.

in vec3 shadowCorner;
flat out uint shadowNumber;
uniform mat4 shadowClipFromLight;

void main()
{
  shadowNumber = uint(gl_VertexID / 3 + 1);
  gl_Position = shadowClipFromLight * vec4(shadowCorner, 1.0);
}
