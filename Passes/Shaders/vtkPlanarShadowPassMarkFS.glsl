//VTK::System::Dec
// Keeps the pixels whose receiver lies on a plane, told by its depth: that is a linear function of the pixel. The
// receiver was drawn by vertices that are rounded, so that it lies between two planes. And it must be of a prop that
// has a receiver there: others may cross the plane.
//VTK::Output::Dec

uniform sampler2DArray shadowDepths;
uniform vec3 shadowDepthBeneath, shadowDepthAbove; // a x + b y + c
uniform float shadowDepthTolerance;
uniform sampler2DArray shadowPlanesOfPixel; // a sum of powers of two, one a plane
uniform float shadowPlaneBit;               // that of this plane

void main()
{
  float planes = texelFetch(shadowPlanesOfPixel, ivec3(gl_FragCoord.xy, 0), 0).r;
  float depth = texelFetch(shadowDepths, ivec3(gl_FragCoord.xy, 0), 0).r;
  vec3 pixel = vec3(gl_FragCoord.xy, 1.0);
  float one = dot(shadowDepthBeneath, pixel), other = dot(shadowDepthAbove, pixel);
  if (mod(floor(planes / shadowPlaneBit), 2.0) < 0.5 || depth < min(one, other) - shadowDepthTolerance || depth > max(one, other) + shadowDepthTolerance)
  {
    discard;
  }
  gl_FragData[0] = vec4(1.0);
}
