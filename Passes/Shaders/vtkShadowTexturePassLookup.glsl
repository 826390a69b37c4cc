// Visibility by shadow texture: how much of a texel is covered by casters that lie before the receiver; 1 less
// that is its visibility. Coverage can be filtered as any picture can: neighbours are blended by the texture's own
// filter, and a wide average is read from smaller copies of it.

uniform sampler2DArray shadowTextures; // r: coverage; g: coverage times depth

// Of what lies before depth p.z; both 0 if the casters there lie behind it.
vec2 shadowTextureAt(int layer, vec3 p, float level)
{
  const vec2 perTexel = 1.0 / vec2(SHADOW_TEXTURE_WIDTH, SHADOW_TEXTURE_HEIGHT);
  vec2 texel = textureLod(shadowTextures, vec3(p.xy * perTexel, float(layer)), level).rg;
  return texel.g < p.z * texel.r ? texel : vec2(0.0);
}

#ifdef SHADOW_TEXTURE_SOFT
// Of each layer: how wide the light's disc is seen through a caster, in texels per depth between caster and
// receiver.
uniform float shadowTextureWidths[SHADOW_TEXTURE_LAYERS];

// The mean over a disc of `width` texels by n places of a sunflower (Vogel 1979). Each is read from the level
// whose texels are as far apart as the places, and the places keep in by so much that the blur of these texels and
// of their filter, of a variance of a quarter of a texel's square, leaves the disc as wide as it is.
vec2 shadowTextureMean(int layer, vec3 p, float width, int n)
{
  float level = clamp(log2(width * inversesqrt(float(n))), 0.0, float(SHADOW_TEXTURE_LEVELS));
  float radius = sqrt(max(0.25 * width * width - exp2(2.0 * level), 0.0));
  vec2 sum = vec2(0.0), way = vec2(1.0, 0.0);
  for (int i = 0; i < n; ++i)
  {
    float reach = radius * sqrt((float(i) + 0.5) / float(n));
    sum += shadowTextureAt(layer, vec3(p.xy + reach * way, p.z), level);
    way = shadowTextureTurned(way);
  }
  return sum / float(n);
}
#endif

// p: texels, and depth, from 0 at the near side of the casters' bounds; behind their far side it is above 1.
float shadowTextureCompare(int layer, vec3 p, vec2 slope)
{
#ifdef SHADOW_TEXTURE_SOFT
  float width = shadowTextureWidths[layer];
  if (width > 0.0 && p.z > 0.0)
  {
    // The mean depth of the casters around, then the light's disc as wide as it is seen through them.
    vec2 around = shadowTextureMean(layer, p, width * p.z, SHADOW_TEXTURE_SEARCHES);
    if (around.r <= 0.0)
    {
      return 1.0;
    }
    float seen = width * max(p.z - around.g / around.r, 0.0);
    return 1.0 - shadowTextureMean(layer, p, seen, SHADOW_TEXTURE_SAMPLES).r;
  }
#endif
  return 1.0 - shadowTextureAt(layer, p, 0.0).r;
}
