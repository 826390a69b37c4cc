//VTK::System::Dec
// A vertex of a shadow volume: a point of the caster, or its image at the far end. Spaces: TC the caster's own, clip
// the eye's.

uniform samplerBuffer shadowPointsTC;
uniform mat4 shadowClipFromCaster;
uniform vec4 shadowLightTC;    // a position and 1, or the direction toward the light and 0
uniform vec4 shadowFarPlaneTC; // n.x = w, where images lie; n = 0: at infinity
uniform float shadowPulledForward; // share of the way to the eye, for edges drawn on their surface

// The plane that a cap is thrown on, and 1 or -1 for the light's side of it; 0 to throw it on none.
uniform vec4 shadowNearPlaneTC;
uniform int shadowNearSide;

#ifdef SHADOW_SOUP
uniform usamplerBuffer shadowSoup; // see vtkshadows::SoupEntry
uniform int shadowSoupFirst;       // entry of the list that is drawn
uniform int shadowSoupFirstPoint;
uniform int shadowSoupTurned;
uniform int shadowSoupCaps;
uniform int shadowSoupImages; // caps: 1 at the far end

// Sides have six vertices a triangle, in pairs of a corner and its image, on a way round it: along both borders, if
// there are two, from end to end. Caps have three, the corners in their own order.
ivec2 shadowPointAndImage()
{
  bool isCap = shadowSoupCaps != 0;
  int n = isCap ? gl_VertexID / 3 : gl_VertexID / 6;
  int vertex = isCap ? gl_VertexID - 3 * n : gl_VertexID - 6 * n;
  uint entry = texelFetch(shadowSoup, shadowSoupFirst + n).r;
  int step = vertex / 2;
  int corner = (int(entry >> 30u) + 1 + (shadowSoupTurned != 0 ? 2 - step : step)) % 3;
  int point = shadowSoupFirstPoint + 3 * int(entry & 0x3fffffffu);
  return isCap ? ivec2(point + vertex, shadowSoupImages) : ivec2(point + corner, vertex & 1);
}
#else
ivec2 shadowPointAndImage()
{
  return ivec2(gl_VertexID / 2, gl_VertexID & 1);
}
#endif

vec4 shadowImage(vec3 p)
{
  vec3 along = p * shadowLightTC.w - shadowLightTC.xyz;
  float steepness = dot(shadowFarPlaneTC.xyz, along);
  return steepness > 0.0
    ? vec4(p + along * ((shadowFarPlaneTC.w - dot(shadowFarPlaneTC.xyz, p)) / steepness), 1.0)
    : vec4(along, 0.0);
}

void main()
{
  ivec2 pointAndImage = shadowPointAndImage();
  vec3 p = texelFetch(shadowPointsTC, pointAndImage.x).xyz;
  if (shadowNearSide != 0)
  {
    // As the light throws it (Blinn 1988); only what lies between light and plane.
    float ofLight = dot(shadowNearPlaneTC, shadowLightTC), ofPoint = dot(shadowNearPlaneTC, vec4(p, 1.0));
    vec4 thrown = ofLight * vec4(p, 1.0) - ofPoint * shadowLightTC;
    vec4 clip = shadowClipFromCaster * (thrown * float(shadowNearSide));
    gl_ClipDistance[0] = ofPoint * float(shadowNearSide);
    gl_Position = vec4(clip.xy, -clip.w, clip.w);
    return;
  }
  gl_ClipDistance[0] = 1.0;
  gl_Position = shadowClipFromCaster * (pointAndImage.y != 0 ? shadowImage(p) : vec4(p, 1.0));
  gl_Position.z -= shadowPulledForward * abs(gl_Position.w);
}
