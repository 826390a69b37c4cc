//VTK::System::Dec
// One face of a shadow volume, added to the count of its pixel.
//VTK::Output::Dec

uniform vec2 shadowWeights; // of faces toward the eye, and away from it

void main()
{
  gl_FragData[0] = vec4(gl_FrontFacing ? shadowWeights.x : shadowWeights.y);
}
