// Visibility on planes, from textures that lie on them, one layer a light and plane.

uniform sampler2DArray shadowPlaneTextureArray;

// Of a receiver on one plane: `place` on its texture, and the layer.
float shadowPlaneTexture(int slot, vec4 place)
{
  return texture(shadowPlaneTextureArray, place.xyz).r;
}

// Of a receiver on several planes, by its position in view coordinates: for each plane the matrix to its texture,
// whose w is the height over the plane, in units of rounding.
uniform mat4 shadowPlaneFromView[SHADOW_PLANE_MATRICES];
uniform int shadowPlaneCount;

float shadowPlaneTextures(int slot, vec4 position)
{
  float lit = 1.0;
  for (int i = slot * shadowPlaneCount; i < (slot + 1) * shadowPlaneCount; ++i)
  {
    vec4 place = shadowPlaneFromView[i] * position;
    float there = texture(shadowPlaneTextureArray, place.xyz).r;
    lit = min(lit, abs(place.w) <= 1.0 ? there : 1.0);
  }
  return lit;
}
