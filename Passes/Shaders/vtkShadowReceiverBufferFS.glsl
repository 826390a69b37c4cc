// Where receivers are drawn into the receiver buffer: position and face normal, view coordinates (VC).

// 1 where this prop takes shadows.
uniform float shadowIsReceiver;
uniform int shadowParallelEye;

// A face's normal in 24 bits, octahedral (Cigolle et al. 2014), plus one: exact in a float, 0 is nothing.
float shadowNormalCode(vec3 n)
{
  vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
  if (n.z < 0.0)
  {
    p = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
  }
  vec2 code = floor((p * 0.5 + 0.5) * 4095.0 + 0.5);
  return code.y * 4096.0 + code.x + 1.0;
}

// Of length 1 to 2, so that squares neither overflow nor vanish, however large or small the scene.
vec3 shadowOfNoScale(vec3 v)
{
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  return largest > 0.0 ? v / largest : vec3(0.0);
}

// A receiver with the normal of an impostor, of any length.
vec4 shadowReceiver(vec3 positionVC, vec3 normalVC)
{
  vec3 scaled = shadowOfNoScale(normalVC);
  vec3 n = scaled != vec3(0.0) ? normalize(scaled) : vec3(0.0, 0.0, 1.0);
  vec3 toEye = shadowParallelEye != 0 ? vec3(0.0, 0.0, 1.0) : -positionVC;
  return vec4(positionVC, shadowIsReceiver * shadowNormalCode(dot(n, toEye) < 0.0 ? -n : n));
}

// A receiver with its face's normal, from the position's screen derivatives.
vec4 shadowReceiver(vec3 positionVC)
{
  return shadowReceiver(positionVC, cross(shadowOfNoScale(dFdx(positionVC)), shadowOfNoScale(dFdy(positionVC))));
}
