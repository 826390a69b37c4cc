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


@dataclass(frozen=True)
class Setting:
    check: Any  # (name, value) -> what apply takes
    apply: Any  # (shadows, renderer, value)


# Checks.


def whole_number(low, high=2**31 - 1):
    return lambda name, value: _checks.whole_number(name, value, low, high)


def number(low, high=float("inf")):
    return lambda name, value: _checks.number(name, value, low, high)


def one_of(values):
    """A name, to the value that VTK has for it."""
    return lambda name, value: values[_checks.one_of(name, value, values)]


def names(name_of, count):
    """The names that VTK has for 0, 1, ..."""
    return {name_of(value): value for value in range(count)}


def depth_bits(name, value):
    if value not in (8, 16, 24, 32):
        raise ValueError(f"{name}: {value!r} is no format of a depth map; give 8, 16, 24 or 32")
    return int(value)


def bias(name, value):
    if isinstance(value, str) and value == "automatic":
        return value
    try:
        constant, slope = value
    except (TypeError, ValueError):
        raise ValueError(f"{name}: {value!r} is neither 'automatic' nor (constant, slope)") from None
    return tuple(_checks.number(name, _checks.finite(name, each), -1e9, 1e9) for each in (constant, slope))


def planes(name, value):
    try:
        planes = numpy.array(list(value), dtype=float).reshape(-1, 4)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: {value!r} is not a list of (nx, ny, nz, offset)") from None
    for plane in planes:
        if not numpy.isfinite(plane).all() or not plane[:3].any():
            raise ValueError(f"{name}: {tuple(plane)} has no normal; give (nx, ny, nz, offset), finite")
    return planes


def debug_view(name, value):
    return _checks.one_of(name, value, debug_views())


def debug_views() -> List[str]:
    return _find.names_from(vtkShadowPass.GetDebugViewNames)


# Where they go.

DEPTH_MAP = vtkShadowPass.GetDepthShadowMapPass
OBJECT_ID = vtkShadowPass.GetObjectIDShadowPass
PLANAR = vtkShadowPass.GetPlanarShadowPass
SHADOW_TEXTURE = vtkShadowPass.GetShadowTexturePass
STENCIL_VOLUME = vtkShadowPass.GetStencilShadowVolumePass


def ray_cast(shadows: vtkShadowPass) -> Any:
    technique = shadows.GetRayCastShadowPass()
    if technique is None:
        raise RuntimeError(
            "this build has no ray-cast technique; configure it with -DVTKSHADOWS_WITH_EMBREE=ON"
        )
    return technique


def of(method, *techniques):
    """By a method of the pass, or of its passes for those techniques."""

    def apply(shadows, renderer, value):
        for each in [technique(shadows) for technique in techniques] or [shadows]:
            getattr(each, method)(value)

    return apply


def of_lights(method):
    """By a method of the pass, for every light that the renderer has now."""

    def apply(shadows, renderer, value):
        for light in renderer.GetLights():
            getattr(shadows, method)(light, value)

    return apply


def set_bias(shadows, renderer, value):
    maps = shadows.GetDepthShadowMapPass()
    if value == "automatic":
        maps.SetBiasMode(vtkDepthShadowMapPass.AUTOMATIC_BIAS)
    else:
        maps.SetBiasMode(vtkDepthShadowMapPass.MANUAL_BIAS)
        maps.SetConstantBias(value[0])
        maps.SetSlopeBias(value[1])


def set_light_samples(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetLightSamples(min(value, 256))
    shadows.GetPlanarShadowPass().SetLightSamples(value)
    shadows.GetStencilShadowVolumePass().SetLightSamples(value)
    if shadows.GetRayCastShadowPass() is not None:
        shadows.GetRayCastShadowPass().SetLightSamples(value)


def set_near_plane(shadows, renderer, value):
    textures = shadows.GetShadowTexturePass()
    if value > 0:
        textures.SetNearPlane(value)
    textures.SetCasterSelection(textures.BY_NEAR_PLANE if value > 0 else textures.BY_FLAG)


def set_planes(shadows, renderer, value):
    planar = shadows.GetPlanarShadowPass()
    planar.RemoveAllPlanes()
    for plane in value:
        planar.AddPlane(*plane)


OBJECT_TYPES = names(vtkObjectIDShadowPass.GetObjectTypeName, vtkObjectIDShadowPass.GetNumberOfObjectTypes())
FILTERS = names(vtkDepthShadowMapPass.GetFilterName, vtkDepthShadowMapPass.GetNumberOfFilters())
TRANSLUCENT_CASTERS = names(
    vtkShadowPass.GetTranslucentCastingName, vtkShadowPass.GetNumberOfTranslucentCastings()
)
BEYOND = {
    "lit": vtkDepthShadowMapPass.LIT_BEYOND,
    "repeat": vtkDepthShadowMapPass.REPEAT_BEYOND,
    "clamp": vtkDepthShadowMapPass.CLAMP_BEYOND,
}
VARIANTS = {
    "automatic": vtkStencilShadowVolumePass.AUTOMATIC,
    "z-fail": vtkStencilShadowVolumePass.Z_FAIL,
    "z-pass": vtkStencilShadowVolumePass.Z_PASS,
    "z-pass-capped": vtkStencilShadowVolumePass.Z_PASS_CAPPED,
    "parity": vtkStencilShadowVolumePass.PARITY,
}
COUNTERS = {
    "automatic": vtkStencilShadowVolumePass.AUTOMATIC_COUNTER,
    "wrapping-stencil": vtkStencilShadowVolumePass.WRAPPING_STENCIL,
    "float": vtkStencilShadowVolumePass.FLOAT_COUNTER,
}
SOFT_METHODS = {
    "sample-lights": vtkPlanarShadowPass.SAMPLE_LIGHTS,
    "offset-planes": vtkPlanarShadowPass.OFFSET_PLANES,
    "plateaus": vtkPlanarShadowPass.PLATEAUS,
}

SETTINGS = {
    "resolution": Setting(whole_number(1), of("SetResolution", DEPTH_MAP, OBJECT_ID, SHADOW_TEXTURE)),
    "object_type": Setting(one_of(OBJECT_TYPES), of("SetObjectType", OBJECT_ID)),
    "object_depth": Setting(_checks.flag, of("SetCombineDepth", OBJECT_ID)),
    "object_depth_bits": Setting(depth_bits, of("SetDepthBits", OBJECT_ID)),
    "object_taps": Setting(whole_number(1, 4), of("SetTaps", OBJECT_ID)),
    "cascades": Setting(whole_number(1, 8), of("SetNumberOfCascades", DEPTH_MAP, OBJECT_ID)),
    "filter": Setting(one_of(FILTERS), of("SetFilter", DEPTH_MAP)),
    "filter_radius": Setting(number(0.5, 64), of("SetFilterRadius", DEPTH_MAP)),
    "filter_taps": Setting(whole_number(1, 256), of("SetFilterTaps", DEPTH_MAP)),
    "depth_bits": Setting(depth_bits, of("SetDepthBits", DEPTH_MAP)),
    "bias": Setting(bias, set_bias),
    "beyond": Setting(one_of(BEYOND), of("SetBeyond", DEPTH_MAP)),
    "light_samples": Setting(whole_number(1, 4096), set_light_samples),
    "epsilon_scale": Setting(number(1e-3, 1e6), of("SetEpsilonScale", ray_cast)),
    "variant": Setting(one_of(VARIANTS), of("SetVariant", STENCIL_VOLUME)),
    "counter": Setting(one_of(COUNTERS), of("SetCounter", STENCIL_VOLUME)),
    "smoothing": Setting(_checks.flag, of("SetSmoothing", STENCIL_VOLUME)),
    "planes": Setting(planes, set_planes),
    "plane_textures": Setting(_checks.flag, of("SetPlaneTextures", PLANAR)),
    "texture_resolution": Setting(whole_number(1), of("SetTextureResolution", PLANAR)),
    "texture_per_caster": Setting(_checks.flag, of("SetTexturePerCaster", SHADOW_TEXTURE)),
    "near_plane": Setting(number(0), set_near_plane),
    "soft_method": Setting(one_of(SOFT_METHODS), of("SetSoftMethod", PLANAR)),
    "debug_view": Setting(debug_view, of("SetDebugView")),
    "maximum_error": Setting(number(0, 100), of("SetMaximumError")),
    "maximum_frame_time": Setting(number(0), of("SetMaximumFrameTime")),
    "strength": Setting(number(0, 1), of_lights("SetLightStrength")),
    "radius": Setting(number(0), of_lights("SetLightRadius")),
    "maximum_distance": Setting(number(0), of_lights("SetLightMaximumDistance")),
    "fade": Setting(number(0, 1), of_lights("SetLightFade")),
    "translucent_casters": Setting(one_of(TRANSLUCENT_CASTERS), of("SetTranslucentCasting")),
    "cull_hidden_faces": Setting(_checks.flag, of("SetCullHiddenFaces")),
}


def check(settings):
    for name in settings:
        if name not in SETTINGS:
            raise ValueError(f"unknown setting {name!r}; there are {', '.join(SETTINGS)}")
    return {name: SETTINGS[name].check(name, value) for name, value in settings.items()}
