// Visibility by several textures of a light, one a caster: all that reach what is drawn.

// Those of slot i lie from shadowTextureFirst[i] up to shadowTextureFirst[i + 1].
uniform int shadowTextureFirst[SHADOW_TEXTURE_SLOTS + 1];
uniform int shadowTextureLayers[SHADOW_TEXTURE_MOST];
uniform mat4 shadowTextureFromView[SHADOW_TEXTURE_MOST];

// position: in view coordinates; all 0: lit.
float shadowTextureEach(int slot, vec4 position)
{
  float visibility = 1.0;
  if (position.w > 0.0)
  {
    for (int i = shadowTextureFirst[slot]; i < shadowTextureFirst[slot + 1]; ++i)
    {
      vec4 q = shadowTextureFromView[i] * position;
      // Behind the projector nothing was drawn.
      visibility *= q.w > 0.0 ? shadowTextureCompare(shadowTextureLayers[i], shadowTexturePlace(q), vec2(0.0)) : 1.0;
    }
  }
  return visibility;
}

float shadowTextureEach(int slot, vec4 position, vec4 along1, vec4 along2)
{
  return shadowTextureEach(slot, position);
}
