//VTK::System::Dec
// Counts by colour: 0 leaves the picture, below 0 is grey, 1 to 6 run from blue to red, more are purple, and
// from 256 on, where eight bits would have wrapped, white.
//VTK::Output::Dec

uniform sampler2DArray shadowCounts;
uniform sampler2DArray shadowDepths;
uniform vec2 shadowViewOrigin; // of the viewport in its framebuffer, pixels
uniform vec2 shadowViewScale;  // pixels of the counts in one of the framebuffer

const vec3 colors[8] = vec3[8](vec3(0.5), vec3(0.0, 0.45, 0.7), vec3(0.35, 0.7, 0.9), vec3(0.0, 0.62, 0.45),
  vec3(0.95, 0.9, 0.25), vec3(0.9, 0.6, 0.0), vec3(0.84, 0.37, 0.0), vec3(0.8, 0.6, 0.7));

void main()
{
  ivec3 texel = ivec3((gl_FragCoord.xy - shadowViewOrigin) * shadowViewScale, 0);
  int count = int(round(texelFetch(shadowCounts, texel, 0).r));
  if (count == 0 || texelFetch(shadowDepths, texel, 0).r == 1.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(count > 255 ? vec3(1.0) : colors[clamp(count, 0, 7)], 0.8);
}
