// Visibility by mask: one texel a pixel of the viewport. Needs SHADOW_MASK_TEXEL, the texel of this fragment.

// `receives`: 1 where this prop takes shadows from these masks, else 0.
float shadowMaskVisibility(sampler2DArray masks, int slot, float receives)
{
  return mix(1.0, texelFetch(masks, ivec3(SHADOW_MASK_TEXEL, slot), 0).r, receives);
}
