//VTK::System::Dec
// Keeps the pixels whose receiver lies on a plane, told by its depth: that is a linear function of the pixel. The
// receiver was drawn by vertices that are rounded, so that it lies between two planes. And it must be of a prop that
// has a receiver there: others may cross the plane.
//VTK::Output::Dec

uniform sampler2DArray shadowReceivers; // on which planes, a sum of powers of two; and depth
uniform vec3 shadowDepthBeneath, shadowDepthAbove; // a x + b y + c
uniform float shadowDepthTolerance;
uniform float shadowPlaneBit; // that of this plane

void main()
{
  vec2 receiver = texelFetch(shadowReceivers, ivec3(gl_FragCoord.xy, 0), 0).rg;
  float planes = receiver.r, depth = receiver.g;
  vec3 pixel = vec3(gl_FragCoord.xy, 1.0);
  float one = dot(shadowDepthBeneath, pixel), other = dot(shadowDepthAbove, pixel);
  bool isOn = depth >= min(one, other) - shadowDepthTolerance && depth <= max(one, other) + shadowDepthTolerance;
  if (!isOn || mod(floor(planes / shadowPlaneBit), 2.0) < 0.5)
  {
    discard;
  }
  gl_FragData[0] = vec4(1.0);
}
