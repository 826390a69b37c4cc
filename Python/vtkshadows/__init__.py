"""Selectable, measured shadows for VTK.

>>> import vtkshadows
>>> vtkshadows.enable(renderer, technique="depth-map", resolution=4096)
>>> window.Render()
>>> lit = vtkshadows.visibility(renderer)        # NumPy, (height, width), row 0 at the top
>>> vtkshadows.error(renderer).mismatch_percent  # against ray-cast truth
0.017

What the technique "stencil-volume" does can be looked at:

>>> vtkshadows.enable(renderer, "stencil-volume", debug_view="volumes")
>>> vtkshadows.volume_counts(renderer)  # NumPy, in how many shadow volumes each pixel lies

Everywhere, `renderer` is a vtkRenderer, a PyVista plotter, or a window with one renderer; `light` is a
vtkLight or an index among the renderer's switched-on lights, in their order. What cannot be done raises
an error that names the value and the remedy: ValueError for an argument, RuntimeError with VTK's own
message for the rest.

The classes underneath are in vtkshadows.vtkShadowsPasses (vtkShadowPass is what `enable` returns).
Shadows as geometry, without rendering: vtkShadowSilhouetteFilter and vtkShadowVolumeFilter.
"""
import operator
import re
from dataclasses import dataclass, field
from typing import Any, List, Optional, Union

import numpy

# Imported for what they register: the classes that draw, and the contexts they draw in.
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import (
    vtkLight,
    vtkProp,
    vtkRenderer,
    vtkRenderPass,
    vtkRenderWindow,
)

from .vtkShadowsFilters import vtkShadowSilhouetteFilter, vtkShadowVolumeFilter
from .vtkShadowsPasses import (
    vtkShadowErrorMeasure,
    vtkShadowPass,
    vtkStencilShadowVolumePass,
)

__all__ = [
    "ShadowError",
    "disable",
    "enable",
    "error",
    "set_casts_shadows",
    "set_receives_shadows",
    "set_stand_in",
    "techniques",
    "visibility",
    "volume_counts",
    "vtkShadowErrorMeasure",
    "vtkShadowPass",
    "vtkShadowSilhouetteFilter",
    "vtkShadowVolumeFilter",
    "vtkStencilShadowVolumePass",
]


def techniques() -> List[str]:
    """Names of the techniques there are in this build, "none" included.

    >>> vtkshadows.techniques()
    ['depth-map', 'stencil-volume', 'ray-cast', 'none']
    """
    return _names_from(vtkShadowPass.GetTechniqueNames)


def enable(
    renderer: Any,
    technique: str = "depth-map",
    delegate: Optional[vtkRenderPass] = None,
    **settings: Any,
) -> vtkShadowPass:
    """Give the lights of `renderer` shadows, from its next frame on.

    Called again, it changes what is named: technique and settings.

    Parameters
    ----------
    technique : one of techniques(), for every light. The pass that is returned takes one per light:
        `shadows.SetLightTechnique(light, "ray-cast")`.
    delegate : the pass that draws the frame. Left out: the pass that the renderer has, or VTK's own way
        of drawing if it has none. stencil-volume and ray-cast need one that draws at the renderer's own
        size: for supersampling, say, make the vtkShadowPass that pass's delegate instead.
    resolution : depth-map: texels on the longer side of each map, 1 or more (2048).
    light_samples : stencil-volume and ray-cast, both: sample lights for a light with a radius, 1 to 4096
        (32 for stencil-volume, 64 for ray-cast).
    variant : stencil-volume: which faces are counted: "automatic" (default), "z-fail", "z-pass",
        "z-pass-capped" or "parity"; see vtkStencilShadowVolumePass::VariantType. The last three are
        for comparison: they are wrong in some views.
    counter : stencil-volume: what they are counted in: "automatic" (default), "wrapping-stencil" (wrong
        from 128 volumes, one in another) or "float".
    smoothing : stencil-volume: make ramps of the steps between sample lights (True).
    epsilon_scale : ray-cast: how far a ray starts off its surface, in rounding bounds, 1e-3 to 1e6 (1).
    strength : 0 (lit everywhere) to 1 (1), for every light that the renderer has now.
    radius : 0 or more (0): size of every light that the renderer has now. stencil-volume and ray-cast
        soften by it. World units; for a directional light the tangent of its half-angle.
    debug_view : "none" (default), "volumes", "silhouette" or "counts": drawn over the frame, it explains
        the first light that casts, whose technique must be stencil-volume; another light by
        `shadows.SetDebugLight(light)`. Colours: see vtkShadowPass::SetDebugView.

    Returns
    -------
    The renderer's vtkShadowPass.

    Raises
    ------
    ValueError : an argument is unknown or out of range; nothing was changed.
    RuntimeError : VTK refused; its message.

    Example
    -------
    >>> shadows = vtkshadows.enable(plotter, "ray-cast", strength=0.7)
    """
    renderer = _find_renderer(renderer)
    _check_technique(technique)
    settings = _check_settings(settings)
    if delegate is not None and not isinstance(delegate, vtkRenderPass):
        raise ValueError(f"delegate: {_kind(delegate)} is not a vtkRenderPass")

    shadows = _shadow_pass(renderer)
    if shadows is None:
        shadows = vtkShadowPass()
        # Kept with the pass, so that it is forgotten with it.
        shadows._vtkshadows_previous = renderer.GetPass()
        shadows.SetDelegatePass(renderer.GetPass())
    if delegate is not None:
        shadows.SetDelegatePass(delegate)

    with _VtkErrors(shadows):
        shadows.SetTechnique(technique)
        for name, value in settings.items():
            _SETTINGS[name].apply(shadows, renderer, value)
    renderer.SetPass(shadows)
    return shadows


def disable(renderer: Any) -> bool:
    """Take the shadows away: the renderer gets back the pass that it had before `enable`.

    Returns whether there were any. The next frame is the one there was before.

    >>> vtkshadows.disable(renderer)
    True
    """
    renderer = _find_renderer(renderer)
    shadows = _shadow_pass(renderer)
    if shadows is None:
        return False
    renderer.SetPass(getattr(shadows, "_vtkshadows_previous", None))
    # The delegate may be what draws from now on: it keeps its resources.
    shadows.SetDelegatePass(None)
    if renderer.GetRenderWindow():
        shadows.ReleaseGraphicsResources(renderer.GetRenderWindow())
    return True


def visibility(renderer: Any, light: Union[vtkLight, int] = 0) -> numpy.ndarray:
    """How much of a light is seen by what each pixel shows, in the current view.

    Returns
    -------
    float32 array of shape (height, width), the renderer's size in pixels, row 0 at the top as in image
    files: 0 (in shadow) to 1 (lit; also the background, and where nothing receives). It is the
    technique's own answer: the light's shadow strength is left out.

    Raises
    ------
    ValueError : no such light, or shadows are not enabled here.
    RuntimeError : VTK could not make it; its message. The window must have rendered once.

    Example
    -------
    >>> imageio.imwrite("mask.png", (255 * vtkshadows.visibility(renderer)).astype("uint8"))
    """
    renderer = _find_renderer(renderer)
    shadows = _require_shadow_pass(renderer)
    light = _find_light(renderer, light)
    image = vtkImageData()
    with _VtkErrors(shadows) as errors:
        errors.require(shadows.GetVisibility(renderer, light, image))
    return _image_to_numpy(image)


def volume_counts(renderer: Any, light: Union[vtkLight, int] = 0) -> numpy.ndarray:
    """In how many shadow volumes of a light lies what each pixel shows, in the current view.

    Returns
    -------
    int32 array of shape (height, width), row 0 at the top as in `visibility`: 0 or less where lit. Where
    nothing receives it says nothing. Of a light with a radius, its last sample light's.

    Raises
    ------
    ValueError : no such light, or shadows are not enabled here.
    RuntimeError : the light's technique is not "stencil-volume", or nothing casts; VTK's message.

    Example
    -------
    >>> vtkshadows.volume_counts(renderer)[240, 320]  # of the pixel in row 240 and column 320
    1
    """
    renderer = _find_renderer(renderer)
    shadows = _require_shadow_pass(renderer)
    light = _find_light(renderer, light)
    image = vtkImageData()
    with _VtkErrors(shadows) as errors:
        errors.require(shadows.GetVolumeCounts(renderer, light, image))
    return numpy.rint(_image_to_numpy(image)).astype(numpy.int32)


@dataclass(frozen=True)
class ShadowError:
    """How far a light's visibility is from the ray-cast truth, in one view.

    Pixels are the receivers' that face the light, those left out whose truth is itself uncertain
    (`uncertain_pixels`). mismatch: visibility differs from the truth by more than 0.5. gross: of those,
    more than 2 px from any true shadow edge; false shadow (acne, bars) or missed shadow (leaks).
    Percentages are of receiver_pixels. The arrays have the renderer's size, row 0 at the top.
    """

    receiver_pixels: int
    shadow_pixels: int
    uncertain_pixels: int
    mismatch_pixels: int
    mismatch_percent: float
    gross_pixels: int
    gross_false_pixels: int
    gross_missed_pixels: int
    gross_percent: float
    mean_absolute_difference: float
    #: float32 (height, width), 0 in shadow to 1 lit; background 1.
    visibility: numpy.ndarray = field(repr=False, compare=False)
    #: float32 (height, width), as visibility.
    truth: numpy.ndarray = field(repr=False, compare=False)
    #: uint8 (height, width, 3), RGB; colours: see vtkShadowErrorMeasure::GetErrorMap.
    error_map: numpy.ndarray = field(repr=False, compare=False)


def error(renderer: Any, light: Union[vtkLight, int] = 0) -> ShadowError:
    """Hold a light's visibility in the current view against the truth, which is ray cast.

    Raises as `visibility` does; RuntimeError in a build without Embree.

    >>> vtkshadows.error(renderer, light=1).gross_pixels
    0
    """
    renderer = _find_renderer(renderer)
    shadows = _require_shadow_pass(renderer)
    light = _find_light(renderer, light)
    measure = vtkShadowErrorMeasure()
    with _VtkErrors(shadows, measure) as errors:
        errors.require(measure.Measure(renderer, light))
    return ShadowError(
        receiver_pixels=measure.GetReceiverPixels(),
        shadow_pixels=measure.GetShadowPixels(),
        uncertain_pixels=measure.GetUncertainPixels(),
        mismatch_pixels=measure.GetMismatchPixels(),
        mismatch_percent=measure.GetMismatchPercent(),
        gross_pixels=measure.GetGrossPixels(),
        gross_false_pixels=measure.GetGrossFalsePixels(),
        gross_missed_pixels=measure.GetGrossMissedPixels(),
        gross_percent=measure.GetGrossPercent(),
        mean_absolute_difference=measure.GetMeanAbsoluteDifference(),
        visibility=_image_to_numpy(measure.GetVisibility()),
        truth=_image_to_numpy(measure.GetTruth()),
        error_map=_image_to_numpy(measure.GetErrorMap()),
    )


def set_casts_shadows(prop: vtkProp, casts: bool) -> None:
    """Say whether `prop` casts shadows. True also makes a translucent prop cast, as if opaque.

    >>> vtkshadows.set_casts_shadows(floor_actor, False)
    """
    vtkShadowPass.SetCastsShadows(_check_prop(prop), bool(casts))


def set_receives_shadows(prop: vtkProp, receives: bool) -> None:
    """Say whether `prop` receives shadows. False: it is always lit.

    >>> vtkshadows.set_receives_shadows(label_actor, False)
    """
    vtkShadowPass.SetReceivesShadows(_check_prop(prop), bool(receives))


def set_stand_in(prop: vtkProp, polydata: Optional[vtkPolyData]) -> None:
    """Let another mesh cast in place of `prop`: a decimated one, or a hull. None: the prop itself, again.

    The mesh (a vtkPolyData, so PyVista's too) is in the prop's own coordinates and moves with it. All
    techniques use it but "ray-cast", which is the truth that `error` holds them against. The prop receives
    the mesh's shadow as any other does: where it lies inside of the mesh, it is dark.

    >>> vtkshadows.set_stand_in(actor, decimate.GetOutput())
    """
    if not (polydata is None or isinstance(polydata, vtkPolyData)):
        raise ValueError(f"{_kind(polydata)} is not a vtkPolyData; give a mesh, or None")
    vtkShadowPass.SetStandIn(_check_prop(prop), polydata)


# --- Settings of enable() --------------------------------------------------------------------------


def _whole_number(name: str, value: Any, low: int, high: float = float("inf")) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise ValueError(f"{name}: {value!r} is not a whole number") from None
    return _in_range(name, number, low, high)


def _number(name: str, value: Any, low: float, high: float = float("inf")) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: {value!r} is not a number") from None
    return _in_range(name, number, low, high)


def _in_range(name, number, low, high):
    # Written so that NaN is out of range, and infinity is where there is no upper end.
    if not (low <= number <= high and number < float("inf")):
        until = "or more" if high == float("inf") else f"to {high:.10g}"
        raise ValueError(f"{name}: {number} is out of range; give {low:g} {until}")
    return number


def _one_of(name: str, value: Any, known: Any) -> Any:
    if value not in list(known):
        raise ValueError(f"{name}: {value!r} is not known; there are {', '.join(known)}")
    return value


def _ray_cast(shadows: vtkShadowPass) -> Any:
    technique = shadows.GetRayCastShadowPass()
    if technique is None:
        raise RuntimeError(
            "this build has no ray-cast technique; configure it with -DVTKSHADOWS_WITH_EMBREE=ON"
        )
    return technique


def _set_resolution(shadows, renderer, value):
    shadows.GetDepthShadowMapPass().SetResolution(value)


def _set_light_samples(shadows, renderer, value):
    shadows.GetStencilShadowVolumePass().SetLightSamples(value)
    if shadows.GetRayCastShadowPass() is not None:
        shadows.GetRayCastShadowPass().SetLightSamples(value)


def _set_epsilon_scale(shadows, renderer, value):
    _ray_cast(shadows).SetEpsilonScale(value)


_VARIANTS = {
    "automatic": vtkStencilShadowVolumePass.AUTOMATIC,
    "z-fail": vtkStencilShadowVolumePass.Z_FAIL,
    "z-pass": vtkStencilShadowVolumePass.Z_PASS,
    "z-pass-capped": vtkStencilShadowVolumePass.Z_PASS_CAPPED,
    "parity": vtkStencilShadowVolumePass.PARITY,
}


def _set_variant(shadows, renderer, value):
    shadows.GetStencilShadowVolumePass().SetVariant(_VARIANTS[value])


_COUNTERS = {
    "automatic": vtkStencilShadowVolumePass.AUTOMATIC_COUNTER,
    "wrapping-stencil": vtkStencilShadowVolumePass.WRAPPING_STENCIL,
    "float": vtkStencilShadowVolumePass.FLOAT_COUNTER,
}


def _set_counter(shadows, renderer, value):
    shadows.GetStencilShadowVolumePass().SetCounter(_COUNTERS[value])


def _set_smoothing(shadows, renderer, value):
    shadows.GetStencilShadowVolumePass().SetSmoothing(value)


def _flag(name, value):
    if not isinstance(value, (bool, numpy.bool_)):
        raise ValueError(f"{name}: {value!r} is not True or False")
    return bool(value)


def _debug_views() -> List[str]:
    return _names_from(vtkShadowPass.GetDebugViewNames)


def _set_debug_view(shadows, renderer, value):
    shadows.SetDebugView(value)


def _set_strength(shadows, renderer, value):
    for light in renderer.GetLights():
        shadows.SetLightStrength(light, value)


def _set_radius(shadows, renderer, value):
    for light in renderer.GetLights():
        shadows.SetLightRadius(light, value)


@dataclass(frozen=True)
class _Setting:
    check: Any  # (name, value) -> value
    apply: Any  # (shadows, renderer, value)


_SETTINGS = {
    "resolution": _Setting(lambda n, v: _whole_number(n, v, 1, 2**31 - 1), _set_resolution),
    "light_samples": _Setting(lambda n, v: _whole_number(n, v, 1, 4096), _set_light_samples),
    "epsilon_scale": _Setting(lambda n, v: _number(n, v, 1e-3, 1e6), _set_epsilon_scale),
    "variant": _Setting(lambda n, v: _one_of(n, v, _VARIANTS), _set_variant),
    "counter": _Setting(lambda n, v: _one_of(n, v, _COUNTERS), _set_counter),
    "smoothing": _Setting(_flag, _set_smoothing),
    "debug_view": _Setting(lambda n, v: _one_of(n, v, _debug_views()), _set_debug_view),
    "strength": _Setting(lambda n, v: _number(n, v, 0, 1), _set_strength),
    "radius": _Setting(lambda n, v: _number(n, v, 0), _set_radius),
}


def _check_settings(settings):
    for name in settings:
        if name not in _SETTINGS:
            raise ValueError(f"unknown setting {name!r}; there are {', '.join(_SETTINGS)}")
    return {name: _SETTINGS[name].check(name, value) for name, value in settings.items()}


def _check_technique(technique):
    known = techniques()
    if technique not in known:
        raise ValueError(f"unknown technique {technique!r}; there are {', '.join(known)}")


def _names_from(fill: Any) -> List[str]:
    names = vtkStringArray()
    fill(names)
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())]


# --- Finding things --------------------------------------------------------------------------------


def _kind(thing: Any) -> str:
    return type(thing).__name__


def _find_renderer(thing: Any) -> vtkRenderer:
    """The vtkRenderer that `thing` is, or that it has: a PyVista plotter's active one, a window's one."""
    if isinstance(thing, vtkRenderer):
        return thing
    active = getattr(thing, "renderer", None)
    if isinstance(active, vtkRenderer):
        return active
    if isinstance(thing, vtkRenderWindow):
        several = list(thing.GetRenderers())
    else:
        several = list(getattr(thing, "renderers", None) or [])
    if len(several) == 1 and isinstance(several[0], vtkRenderer):
        return several[0]
    if several:
        raise ValueError(f"{_kind(thing)} has {len(several)} renderers; give one of them")
    raise ValueError(f"{_kind(thing)} is not a vtkRenderer and has none; give the renderer itself")


def _shadow_pass(renderer: vtkRenderer) -> Optional[vtkShadowPass]:
    shadows = renderer.GetPass()
    return shadows if isinstance(shadows, vtkShadowPass) else None


def _require_shadow_pass(renderer: vtkRenderer) -> vtkShadowPass:
    shadows = _shadow_pass(renderer)
    if shadows is None:
        raise ValueError("this renderer has no shadows; call vtkshadows.enable(renderer) first")
    return shadows


def _find_light(renderer: vtkRenderer, light: Union[vtkLight, int]) -> vtkLight:
    if isinstance(light, vtkLight):
        if not renderer.GetLights().IsItemPresent(light):
            raise ValueError("light: not one of this renderer's; add it with AddLight")
        return light
    switched_on = [each for each in renderer.GetLights() if each.GetSwitch()]
    if not switched_on:
        raise ValueError(
            "this renderer has no light switched on; add one, or render once to get VTK's default"
        )
    try:
        index = operator.index(light)
    except TypeError:
        raise ValueError(f"light: {light!r} is neither a vtkLight nor an index") from None
    if not 0 <= index < len(switched_on):
        raise ValueError(
            f"light: {index} is out of range; this renderer has {len(switched_on)} switched on, from 0"
        )
    return switched_on[index]


def _check_prop(prop: Any) -> vtkProp:
    if not isinstance(prop, vtkProp):
        raise ValueError(f"{_kind(prop)} is not a vtkProp; give an actor")
    return prop


def _image_to_numpy(image: vtkImageData) -> numpy.ndarray:
    """The scalars of a 2D image as (height, width[, components]), row 0 at the top."""
    width, height, _ = image.GetDimensions()
    scalars = vtk_to_numpy(image.GetPointData().GetScalars())
    shape = (height, width) + scalars.shape[1:]
    # VTK's rows go up from the bottom. A copy: the image dies with the call.
    return numpy.array(scalars.reshape(shape)[::-1], order="C")


# --- VTK's errors as exceptions --------------------------------------------------------------------


class _VtkErrors:
    """While it lasts, errors of a vtkShadowPass (and of `others`) are collected instead of displayed.

    At its end the first one is raised as a RuntimeError.
    """

    def __init__(self, shadows: vtkShadowPass, *others: Any):
        parts = (
            shadows,
            shadows.GetDepthShadowMapPass(),
            shadows.GetStencilShadowVolumePass(),
            shadows.GetRayCastShadowPass(),
            shadows.GetScene(),
            *others,
        )
        self._objects = [each for each in parts if each is not None]
        self._messages: List[str] = []

    def require(self, done: bool) -> None:
        """Note a call that failed without saying why."""
        if not done and not self._messages:
            self._messages.append("VTK could not do it, and did not say why")

    def __enter__(self) -> "_VtkErrors":
        @calldata_type(VTK_STRING)
        def collect(caller, event, message):
            self._messages.append(_plain_message(message))

        self._tags = [(each, each.AddObserver("ErrorEvent", collect)) for each in self._objects]
        return self

    def __exit__(self, kind, value, traceback) -> None:
        for each, tag in self._tags:
            each.RemoveObserver(tag)
        if kind is None and self._messages:
            raise RuntimeError(self._messages[0])


def _plain_message(message: str) -> str:
    """VTK's message without file, line and address: "ERROR: In f.cxx, line 1\\nvtkX (0x1): text"."""
    text = re.sub(r"^(ERROR|Warning): In .*, line \d+\n", "", message).strip()
    return re.sub(r"^(\w+) \(0x[0-9a-f]+\): ", r"\1: ", text)
