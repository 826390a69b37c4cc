// How a spot light falls off across its cone, beside what VTK's lighting does. q: the receiver in the light's axes,
// right, up, and against the way that it shines.

// 1 in the inner cone, 0 from the side on, between them the smoothstep of the angle's cosine. cone: 1 less the
// cosine of the side; one over the range. 1 less a cosine is half the square of a chord: of a narrow cone the
// cosine itself has hardly a digit to tell angles by.
float shadowSmoothCone(vec3 q, vec2 cone)
{
  vec3 chord = normalize(q) + vec3(0.0, 0.0, 1.0);
  float way = clamp((cone.x - 0.5 * dot(chord, chord)) * cone.y, 0.0, 1.0);
  return way * way * (3.0 - 2.0 * way);
}

// The image as the light projects it, black beside it. perTangent: one over the tangent of the cone's angle.
vec3 shadowProjected(vec3 q, float perTangent, sampler2D image)
{
  vec2 at = q.xy * (perTangent / -q.z);
  vec2 rim = 0.5 / vec2(textureSize(image, 0));
  vec3 color = texture(image, clamp(0.5 + 0.5 * at, rim, 1.0 - rim)).rgb;
  return q.z < 0.0 && max(abs(at.x), abs(at.y)) <= 1.0 ? color : vec3(0.0);
}
