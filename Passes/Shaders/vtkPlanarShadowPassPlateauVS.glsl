//VTK::System::Dec
// A vertex of a plateau: on the plane, and the visibility there.

in vec4 shadowVertex; // place, less an origin, and visibility
uniform mat4 shadowClipFromPlateau;
out float shadowVisibility;

void main()
{
  shadowVisibility = shadowVertex.w;
  gl_Position = shadowClipFromPlateau * vec4(shadowVertex.xyz, 1.0);
}
