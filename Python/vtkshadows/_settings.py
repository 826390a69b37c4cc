"""The settings of enable(): how each is checked, and where it goes."""

from dataclasses import dataclass
from typing import Any, List

import numpy

from . import _checks, _find
from .vtkShadowsPasses import (
    vtkDepthShadowMapPass,
    vtkObjectIDShadowPass,
    vtkPlanarShadowPass,
    vtkShadowPass,
    vtkStencilShadowVolumePass,
)


def ray_cast(shadows: vtkShadowPass) -> Any:
    technique = shadows.GetRayCastShadowPass()
    if technique is None:
        raise RuntimeError(
            "this build has no ray-cast technique; configure it with -DVTKSHADOWS_WITH_EMBREE=ON"
        )
    return technique


def set_resolution(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetResolution(value)
    shadows.GetObjectIDShadowPass().SetResolution(value)
    shadows.GetShadowTexturePass().SetResolution(value)


OBJECT_TYPES = {
    "prop": vtkObjectIDShadowPass.PROP,
    "block": vtkObjectIDShadowPass.BLOCK,
    "instance": vtkObjectIDShadowPass.INSTANCE,
    "piece": vtkObjectIDShadowPass.PIECE,
}


def set_object_type(shadows, renderer, value):
    shadows.GetObjectIDShadowPass().SetObjectType(OBJECT_TYPES[value])


def set_object_depth(shadows, renderer, value):
    shadows.GetObjectIDShadowPass().SetCombineDepth(value)


def set_object_depth_bits(shadows, renderer, value):
    shadows.GetObjectIDShadowPass().SetDepthBits(value)


def set_object_taps(shadows, renderer, value):
    shadows.GetObjectIDShadowPass().SetTaps(value)


def set_cascades(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetNumberOfCascades(value)
    shadows.GetObjectIDShadowPass().SetNumberOfCascades(value)


FILTERS = {
    vtkDepthShadowMapPass.GetFilterName(each): each
    for each in range(vtkDepthShadowMapPass.GetNumberOfFilters())
}


def set_filter(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetFilter(FILTERS[value])


def set_filter_radius(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetFilterRadius(value)


def set_filter_taps(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetFilterTaps(value)


def depth_bits(name, value):
    if value not in (8, 16, 24, 32):
        raise ValueError(f"{name}: {value!r} is no format of a depth map; give 8, 16, 24 or 32")
    return int(value)


def set_depth_bits(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetDepthBits(value)


def bias(name, value):
    if isinstance(value, str) and value == "automatic":
        return value
    try:
        constant, slope = value
    except (TypeError, ValueError):
        raise ValueError(f"{name}: {value!r} is neither 'automatic' nor (constant, slope)") from None
    return tuple(_checks.number(name, _checks.finite(name, each), -1e9, 1e9) for each in (constant, slope))


def set_bias(shadows, renderer, value):
    maps = shadows.GetDepthShadowMapPass()
    if value == "automatic":
        maps.SetBiasMode(vtkDepthShadowMapPass.AUTOMATIC_BIAS)
    else:
        maps.SetBiasMode(vtkDepthShadowMapPass.MANUAL_BIAS)
        maps.SetConstantBias(value[0])
        maps.SetSlopeBias(value[1])


BEYOND = {
    "lit": vtkDepthShadowMapPass.LIT_BEYOND,
    "repeat": vtkDepthShadowMapPass.REPEAT_BEYOND,
    "clamp": vtkDepthShadowMapPass.CLAMP_BEYOND,
}


def set_beyond(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetBeyond(BEYOND[value])


def set_light_samples(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetLightSamples(min(value, 256))
    shadows.GetPlanarShadowPass().SetLightSamples(value)
    shadows.GetStencilShadowVolumePass().SetLightSamples(value)
    if shadows.GetRayCastShadowPass() is not None:
        shadows.GetRayCastShadowPass().SetLightSamples(value)


def set_epsilon_scale(shadows, renderer, value):
    ray_cast(shadows).SetEpsilonScale(value)


VARIANTS = {
    "automatic": vtkStencilShadowVolumePass.AUTOMATIC,
    "z-fail": vtkStencilShadowVolumePass.Z_FAIL,
    "z-pass": vtkStencilShadowVolumePass.Z_PASS,
    "z-pass-capped": vtkStencilShadowVolumePass.Z_PASS_CAPPED,
    "parity": vtkStencilShadowVolumePass.PARITY,
}


def set_variant(shadows, renderer, value):
    shadows.GetStencilShadowVolumePass().SetVariant(VARIANTS[value])


COUNTERS = {
    "automatic": vtkStencilShadowVolumePass.AUTOMATIC_COUNTER,
    "wrapping-stencil": vtkStencilShadowVolumePass.WRAPPING_STENCIL,
    "float": vtkStencilShadowVolumePass.FLOAT_COUNTER,
}


def set_counter(shadows, renderer, value):
    shadows.GetStencilShadowVolumePass().SetCounter(COUNTERS[value])


def set_smoothing(shadows, renderer, value):
    shadows.GetStencilShadowVolumePass().SetSmoothing(value)


SOFT_METHODS = {
    "sample-lights": vtkPlanarShadowPass.SAMPLE_LIGHTS,
    "offset-planes": vtkPlanarShadowPass.OFFSET_PLANES,
    "plateaus": vtkPlanarShadowPass.PLATEAUS,
}


def set_soft_method(shadows, renderer, value):
    shadows.GetPlanarShadowPass().SetSoftMethod(SOFT_METHODS[value])


def set_plane_textures(shadows, renderer, value):
    shadows.GetPlanarShadowPass().SetPlaneTextures(value)


def set_texture_resolution(shadows, renderer, value):
    shadows.GetPlanarShadowPass().SetTextureResolution(value)


def set_texture_per_caster(shadows, renderer, value):
    shadows.GetShadowTexturePass().SetTexturePerCaster(value)


def set_near_plane(shadows, renderer, value):
    textures = shadows.GetShadowTexturePass()
    if value > 0:
        textures.SetNearPlane(value)
    textures.SetCasterSelection(textures.BY_NEAR_PLANE if value > 0 else textures.BY_FLAG)


def planes(name, value):
    try:
        planes = numpy.array(list(value), dtype=float).reshape(-1, 4)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: {value!r} is not a list of (nx, ny, nz, offset)") from None
    for plane in planes:
        if not numpy.isfinite(plane).all() or not plane[:3].any():
            raise ValueError(f"{name}: {tuple(plane)} has no normal; give (nx, ny, nz, offset), finite")
    return planes


def set_planes(shadows, renderer, value):
    planar = shadows.GetPlanarShadowPass()
    planar.RemoveAllPlanes()
    for plane in value:
        planar.AddPlane(*plane)


def debug_views() -> List[str]:
    return _find.names_from(vtkShadowPass.GetDebugViewNames)


def set_debug_view(shadows, renderer, value):
    shadows.SetDebugView(value)


def set_maximum_error(shadows, renderer, value):
    shadows.SetMaximumError(value)


def set_maximum_frame_time(shadows, renderer, value):
    shadows.SetMaximumFrameTime(value)


def set_strength(shadows, renderer, value):
    for light in renderer.GetLights():
        shadows.SetLightStrength(light, value)


def set_maximum_distance(shadows, renderer, value):
    for light in renderer.GetLights():
        shadows.SetLightMaximumDistance(light, value)


def set_fade(shadows, renderer, value):
    for light in renderer.GetLights():
        shadows.SetLightFade(light, value)


TRANSLUCENT_CASTERS = {
    "none": vtkShadowPass.TRANSLUCENT_NONE,
    "opaque": vtkShadowPass.TRANSLUCENT_OPAQUE,
    "stochastic": vtkShadowPass.TRANSLUCENT_STOCHASTIC,
    "transmittance": vtkShadowPass.TRANSLUCENT_TRANSMITTANCE,
}


def set_translucent_casters(shadows, renderer, value):
    shadows.SetTranslucentCasting(TRANSLUCENT_CASTERS[value])


def set_radius(shadows, renderer, value):
    for light in renderer.GetLights():
        shadows.SetLightRadius(light, value)


@dataclass(frozen=True)
class Setting:
    check: Any  # (name, value) -> value
    apply: Any  # (shadows, renderer, value)


SETTINGS = {
    "resolution": Setting(lambda n, v: _checks.whole_number(n, v, 1, 2**31 - 1), set_resolution),
    "object_type": Setting(lambda n, v: _checks.one_of(n, v, OBJECT_TYPES), set_object_type),
    "object_depth": Setting(_checks.flag, set_object_depth),
    "object_depth_bits": Setting(depth_bits, set_object_depth_bits),
    "object_taps": Setting(lambda n, v: _checks.whole_number(n, v, 1, 4), set_object_taps),
    "cascades": Setting(lambda n, v: _checks.whole_number(n, v, 1, 8), set_cascades),
    "filter": Setting(lambda n, v: _checks.one_of(n, v, FILTERS), set_filter),
    "filter_radius": Setting(lambda n, v: _checks.number(n, v, 0.5, 64), set_filter_radius),
    "filter_taps": Setting(lambda n, v: _checks.whole_number(n, v, 1, 256), set_filter_taps),
    "depth_bits": Setting(depth_bits, set_depth_bits),
    "bias": Setting(bias, set_bias),
    "beyond": Setting(lambda n, v: _checks.one_of(n, v, BEYOND), set_beyond),
    "light_samples": Setting(lambda n, v: _checks.whole_number(n, v, 1, 4096), set_light_samples),
    "epsilon_scale": Setting(lambda n, v: _checks.number(n, v, 1e-3, 1e6), set_epsilon_scale),
    "variant": Setting(lambda n, v: _checks.one_of(n, v, VARIANTS), set_variant),
    "counter": Setting(lambda n, v: _checks.one_of(n, v, COUNTERS), set_counter),
    "smoothing": Setting(_checks.flag, set_smoothing),
    "planes": Setting(planes, set_planes),
    "plane_textures": Setting(_checks.flag, set_plane_textures),
    "texture_resolution": Setting(
        lambda n, v: _checks.whole_number(n, v, 1, 2**31 - 1), set_texture_resolution
    ),
    "texture_per_caster": Setting(_checks.flag, set_texture_per_caster),
    "near_plane": Setting(lambda n, v: _checks.number(n, v, 0), set_near_plane),
    "soft_method": Setting(lambda n, v: _checks.one_of(n, v, SOFT_METHODS), set_soft_method),
    "debug_view": Setting(lambda n, v: _checks.one_of(n, v, debug_views()), set_debug_view),
    "maximum_error": Setting(lambda n, v: _checks.number(n, v, 0, 100), set_maximum_error),
    "maximum_frame_time": Setting(lambda n, v: _checks.number(n, v, 0), set_maximum_frame_time),
    "strength": Setting(lambda n, v: _checks.number(n, v, 0, 1), set_strength),
    "radius": Setting(lambda n, v: _checks.number(n, v, 0), set_radius),
    "maximum_distance": Setting(lambda n, v: _checks.number(n, v, 0), set_maximum_distance),
    "fade": Setting(lambda n, v: _checks.number(n, v, 0, 1), set_fade),
    "translucent_casters": Setting(lambda n, v: _checks.one_of(n, v, TRANSLUCENT_CASTERS), set_translucent_casters),
}


def check(settings):
    for name in settings:
        if name not in SETTINGS:
            raise ValueError(f"unknown setting {name!r}; there are {', '.join(SETTINGS)}")
    return {name: SETTINGS[name].check(name, value) for name, value in settings.items()}
