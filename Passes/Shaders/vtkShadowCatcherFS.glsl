// A shadow catcher: its colour where light is missing, transparent elsewhere. VTK's own lighting code
// sums the light that arrives: in red with its visibility, in green without.

uniform vec3 shadowCatcherColor;
uniform float shadowCatcherStrength;
// Share of the way from the rim to the middle over which it fades in; 0: not at all.
uniform float shadowCatcherFade;
// From view coordinates to -1..1 in the catcher's bounds; 0 along an axis without extent.
uniform mat4 shadowCatcherBoxFromView;

// Luminance of linear RGB, ITU-R BT.709.
float shadowLuminance(vec3 color)
{
  return dot(color, vec3(0.2126, 0.7152, 0.0722));
}

vec3 shadowCatcherLight(vec3 lightColor, float visibility)
{
  return shadowLuminance(lightColor) * vec3(visibility, 1.0, 0.0);
}

// A white, matt surface for the lighting; given back what it was: the luminance of its ambient and of
// its diffuse colour.
vec2 shadowCatcherSurface(inout vec3 ambient, inout vec3 diffuse, inout vec3 specular)
{
  vec2 surface = vec2(shadowLuminance(ambient), shadowLuminance(diffuse));
  ambient = vec3(0.0);
  diffuse = vec3(1.0);
  specular = vec3(0.0);
  return surface;
}

// light: red and green as above; surface: of shadowCatcherSurface. The alpha is the share that such a
// surface would lose of its brightness.
vec4 shadowCatch(vec3 light, vec2 surface, vec4 positionVC)
{
  float missing = surface.y * max(light.g - light.r, 0.0);
  float whole = surface.x + surface.y * light.g;
  vec3 inside = 1.0 - abs((shadowCatcherBoxFromView * positionVC).xyz);
  vec3 faded = shadowCatcherFade > 0.0 ? smoothstep(vec3(0.0), vec3(shadowCatcherFade), inside) : vec3(1.0);
  float alpha = missing > 0.0 ? missing / whole * faded.x * faded.y * faded.z : 0.0;
  return vec4(shadowCatcherColor, clamp(shadowCatcherStrength * alpha, 0.0, 1.0));
}
