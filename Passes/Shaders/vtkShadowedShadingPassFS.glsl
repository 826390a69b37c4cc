// Visibility by mask: one texel a pixel of the viewport. Needs SHADOW_MASK_TEXEL, the texel of this fragment.

// 1 where this prop takes shadows from masks.
uniform float shadowReceivesMask;

float shadowMaskVisibility(sampler2DArray masks, int slot)
{
  return mix(1.0, texelFetch(masks, ivec3(SHADOW_MASK_TEXEL, slot), 0).r, shadowReceivesMask);
}
