"""Selectable, measured shadows for VTK.

>>> import vtkshadows
>>> vtkshadows.enable(renderer, technique="depth-map", resolution=4096)
>>> window.Render()
>>> lit = vtkshadows.visibility(renderer)        # NumPy, (height, width), row 0 at the top
>>> vtkshadows.error(renderer).mismatch_percent  # against ray-cast truth
0.017

A floor that shows nothing but the shadow grounds a figure, on a page of any colour:

>>> vtkshadows.add_floor(renderer, shadow="ray-cast")
>>> vtkshadows.screenshot(window, "figure.png")  # transparent

What the technique "stencil-volume" does can be looked at:

>>> vtkshadows.enable(renderer, "stencil-volume", debug_view="volumes")
>>> vtkshadows.volume_counts(renderer)  # NumPy, in how many shadow volumes each pixel lies

Everywhere, `renderer` is a vtkRenderer, a PyVista plotter, or a window with one renderer; `light` is a
vtkLight or an index among the renderer's switched-on lights, in their order. What cannot be done raises
an error that names the value and the remedy: ValueError for an argument, RuntimeError with VTK's own
message for the rest.

The classes underneath are in vtkshadows.vtkShadowsPasses (vtkShadowPass is what `enable` returns).
Shadows as geometry, without rendering: vtkShadowSilhouetteFilter, vtkShadowVolumeFilter and
vtkPlanarShadowFilter.
"""
import os
import warnings
from dataclasses import dataclass, field
from typing import Any, List, Optional, Union

import numpy

# Imported for what they register: the classes that draw, and the contexts they draw in.
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkProp,
    vtkRenderPass,
    vtkTexture,
    vtkWindowToImageFilter,
)

from . import _checks, _errors, _find, _floors, _images, _settings
from .vtkShadowsFilters import vtkPlanarShadowFilter, vtkShadowSilhouetteFilter, vtkShadowVolumeFilter
from .vtkShadowsPasses import (
    vtkDepthShadowMapPass,
    vtkObjectIDShadowPass,
    vtkPlanarShadowPass,
    vtkShadowErrorMeasure,
    vtkShadowFloor,
    vtkShadowMatte,
    vtkShadowPass,
    vtkShadowTexturePass,
    vtkStencilShadowVolumePass,
)

__all__ = [
    "ShadowError",
    "add_floor",
    "disable",
    "enable",
    "error",
    "explanation",
    "screenshot",
    "set_casts_shadows",
    "set_light_texture",
    "set_receives_shadows",
    "set_shadow_catcher",
    "set_smooth_cone",
    "set_stand_in",
    "techniques",
    "visibilities",
    "visibility",
    "volume_counts",
    "vtkDepthShadowMapPass",
    "vtkObjectIDShadowPass",
    "vtkPlanarShadowFilter",
    "vtkPlanarShadowPass",
    "vtkShadowErrorMeasure",
    "vtkShadowFloor",
    "vtkShadowMatte",
    "vtkShadowPass",
    "vtkShadowSilhouetteFilter",
    "vtkShadowTexturePass",
    "vtkShadowVolumeFilter",
    "vtkStencilShadowVolumePass",
]


def techniques() -> List[str]:
    """Names of the techniques there are in this build, "auto" and "none" included.

    >>> vtkshadows.techniques()
    ['depth-map', 'object-id', 'planar', 'shadow-texture', 'stencil-volume', 'ray-cast', 'auto', 'none']
    """
    return _find.names_from(vtkShadowPass.GetTechniqueNames)


def enable(
    renderer: Any,
    technique: str = "auto",
    delegate: Optional[vtkRenderPass] = None,
    **settings: Any,
) -> vtkShadowPass:
    """Give the lights of `renderer` shadows, from its next frame on.

    Called again, it changes what is named: technique and settings.

    Parameters
    ----------
    technique : one of techniques(), for every light. "auto" (default): chosen for each light, by what the
        scene asks and the two budgets below; `explanation` says why. The pass that is returned takes one
        per light: `shadows.SetLightTechnique(light, "ray-cast")`.
    maximum_error : auto: percent of the receiver pixels that may be wrong, 0 to 100 (0: no gross error); of
        a light with a radius the mean absolute difference in percent. Left out, the light has no gross error,
        and with a radius a mean difference of at most 1 %, 4 % within penumbras.
    maximum_frame_time : auto: milliseconds that a frame may take, 0 or more (0: any).
    delegate : the pass that draws the frame. Left out: the pass that the renderer has, or VTK's own way
        of drawing if it has none. stencil-volume and ray-cast need one that draws at the renderer's own
        size: for supersampling, say, make the vtkShadowPass that pass's delegate instead.
    resolution : depth-map, object-id and shadow-texture: texels on the longer side of each map, 1 or more
        (2048).
    object_type : object-id: what has an ID of its own: "prop" (default), "block" (of composite data sets,
        too), "instance" (of glyphs, too) or "piece" (connected pieces of meshes, too).
    object_depth : object-id: keep a depth beside each ID (True). False: no object shadows itself.
    object_depth_bits : object-id: bits of that depth, within the object's own range: 8, 16 (default), 24 or
        32 (a float). With 24 there are 255 IDs, which further objects share; else 65535.
    object_taps : object-id: test n x n texels, 1 to 4 (2): blended, or without depths in shadow where all
        agree.
    cascades : depth-map and object-id: maps of a directional light at most, 1 to 8 (1): each as fine as what
        it serves is near. For a scene that reaches far beyond what is near to the eye.
    filter : depth-map: how a receiver is held against the map: "percentage-closer" (default), "none",
        "hardware", "disc", "soft" (soft shadows of lights with a radius), "sample-lights" (the same, nearer
        to the truth and slower), "variance", "exponential" or "exact" (edges of the
        casters' triangles, not of texels); see vtkDepthShadowMapPass::FilterType.
    filter_radius : filters "disc", "variance" and "exponential": radius of the kernel in texels, 0.5 to 64
        (3).
    filter_taps : filters "disc" and "soft": taps of the kernel, 1 to 256 (32); "soft" takes up to three times as
        many where the kernel is wide.
    depth_bits : depth-map: bits of a map's depths: 32 (default), 24, 16 or 8.
    bias : depth-map: "automatic" (default), or, to compare, (constant, slope) as glPolygonOffset has them:
        steps of the map's format, and shares of the receiver's slope.
    beyond : depth-map: what lies beyond the map: "lit" (default), or, to show what goes wrong, "repeat" or
        "clamp".
    light_samples : planar, stencil-volume, ray-cast and the filter "sample-lights" of depth-map: sample
        lights for a light with a radius, 1 to 4096 (32 for stencil-volume, 64 for the others; of planar the
        most that it takes; of depth-map 256 at most, whatever is given).
    variant : stencil-volume: which faces are counted: "automatic" (default), "z-fail", "z-pass",
        "z-pass-capped" or "parity"; see vtkStencilShadowVolumePass::VariantType. The last three are
        for comparison: they are wrong in some views.
    counter : stencil-volume: what they are counted in: "automatic" (default), "wrapping-stencil" (wrong
        from 128 volumes, one in another) or "float".
    smoothing : stencil-volume: make ramps of the steps between sample lights (True).
    planes : planar: planes that receive, beside those that it finds: a list of (nx, ny, nz, offset), world
        coordinates, what lies on the plane has n.x = offset (none).
    plane_textures : planar: keep each light's shadow on each plane as a texture fixed in the world: cheap
        while only the camera moves, edges as coarse as its texels (False).
    texture_resolution : planar: texels on the longer side of such a texture, 1 or more (2048).
    soft_method : planar: how a light with a radius is made soft: "sample-lights" (default),
        "offset-planes" or "plateaus"; see vtkPlanarShadowPass::SoftMethodType.
    texture_per_caster : shadow-texture: a texture for each prop that casts instead of one for all of a
        light: then casters take the shadows of others, and only those that changed are drawn again (False).
    near_plane : shadow-texture: what lies before a plane this far before the light, world units, casts and
        takes no shadow, and the rest receives and casts none; 0 (default): casters are told by
        `set_casts_shadows` alone. See vtkShadowTexturePass::SetNearPlane.
    epsilon_scale : ray-cast: how far a ray starts off its surface, in rounding bounds, 1e-3 to 1e6 (1).
    strength : 0 (lit everywhere) to 1 (1), for every light that the renderer has now.
    maximum_distance : 0 or more (0: any): how far from the eye shadows reach, world units, for every light that
        the renderer has now.
    fade : 0 to 1 (0.1): the share of that distance over which they fade out before its end.
    translucent_casters : how translucent props cast: "none" (default), "opaque", "stochastic": by their
        opacity, in a grain that wide filters smooth, or "transmittance": the same without grain, by
        "depth-map"; see vtkShadowPass::SetTranslucentCasting.
    cull_hidden_faces : leave out the faces of closed, opaque actors that are turned away from the eye
        (False): a frame needs less time, and single pixels on silhouettes differ; see
        vtkShadowPass::SetCullHiddenFaces.
    radius : 0 or more (0): size of every light that the renderer has now. planar, shadow-texture,
        stencil-volume, ray-cast and the filters "soft" and "sample-lights" of depth-map soften by it. World
        units; for a directional light the tangent of its half-angle.
    debug_view : "none" (default); "volumes", "silhouette" or "counts" for a light of stencil-volume;
        "cascades", "texel-density", "map" or "lit-part" for one of a technique by maps: drawn over the frame, it
        explains the first light that casts; another light by `shadows.SetDebugLight(light)`. Colours: see
        vtkShadowPass::SetDebugView.

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
    renderer = _find.renderer_of(renderer)
    _check_technique(technique)
    settings = _settings.check(settings)
    if delegate is not None and not isinstance(delegate, vtkRenderPass):
        raise ValueError(f"delegate: {_find.kind(delegate)} is not a vtkRenderPass")

    shadows = _find.shadow_pass_of(renderer)
    if shadows is None:
        shadows = vtkShadowPass()
        # Kept with the pass, so that it is forgotten with it.
        shadows._vtkshadows_previous = renderer.GetPass()
        shadows.SetDelegatePass(renderer.GetPass())
    if delegate is not None:
        shadows.SetDelegatePass(delegate)

    with _errors.VtkErrors(shadows):
        shadows.SetTechnique(technique)
        for name, value in settings.items():
            _settings.SETTINGS[name].apply(shadows, renderer, value)
    renderer.SetPass(shadows)
    return shadows


def disable(renderer: Any) -> bool:
    """Take the shadows away: the renderer gets back the pass that it had before `enable`.

    Returns whether there were any. The next frame is the one there was before.

    >>> vtkshadows.disable(renderer)
    True
    """
    renderer = _find.renderer_of(renderer)
    shadows = _find.shadow_pass_of(renderer)
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
    renderer = _find.renderer_of(renderer)
    shadows = _find.require_shadow_pass(renderer)
    light = _find.light_of(renderer, light)
    image = vtkImageData()
    with _errors.VtkErrors(shadows) as errors:
        errors.require(shadows.GetVisibility(renderer, light, image))
    return _find.image_to_numpy(image)


def visibilities(renderer: Any) -> numpy.ndarray:
    """`visibility` of all lights that are switched on, in their order, in the current view.

    What all lights are drawn by is made once: of n lights it takes far less than n calls for one.

    Returns
    -------
    float32 array of shape (lights, height, width), each as `visibility` gives it.

    Raises
    ------
    ValueError : shadows are not enabled here.
    RuntimeError : no light is on, or VTK could not make it; its message. The window must have rendered once.

    Example
    -------
    >>> lit = vtkshadows.visibilities(renderer).mean(axis=0)  # the share of lights that each pixel sees
    """
    renderer = _find.renderer_of(renderer)
    shadows = _find.require_shadow_pass(renderer)
    image = vtkImageData()
    with _errors.VtkErrors(shadows) as errors:
        errors.require(shadows.GetVisibilities(renderer, image))
    values = _find.image_to_numpy(image)
    return numpy.ascontiguousarray(numpy.moveaxis(numpy.atleast_3d(values), 2, 0))


def explanation(renderer: Any, light: Union[vtkLight, int] = 0) -> str:
    """Why a light has its technique, in a sentence that names it first; of the last frame.

    Raises ValueError if there is no such light, or shadows are not enabled here.

    >>> vtkshadows.explanation(renderer)
    'depth-map (1024 texels): 0.0071 % wrong and no gross error as measured in this view; 12.8 ms a frame, ...'
    """
    renderer = _find.renderer_of(renderer)
    shadows = _find.require_shadow_pass(renderer)
    return shadows.GetExplanation(_find.light_of(renderer, light))


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
    renderer = _find.renderer_of(renderer)
    shadows = _find.require_shadow_pass(renderer)
    light = _find.light_of(renderer, light)
    image = vtkImageData()
    with _errors.VtkErrors(shadows) as errors:
        errors.require(shadows.GetVolumeCounts(renderer, light, image))
    return numpy.rint(_find.image_to_numpy(image)).astype(numpy.int32)


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
    renderer = _find.renderer_of(renderer)
    shadows = _find.require_shadow_pass(renderer)
    light = _find.light_of(renderer, light)
    measure = vtkShadowErrorMeasure()
    with _errors.VtkErrors(shadows, measure) as errors:
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
        visibility=_find.image_to_numpy(measure.GetVisibility()),
        truth=_find.image_to_numpy(measure.GetTruth()),
        error_map=_find.image_to_numpy(measure.GetErrorMap()),
    )


def set_casts_shadows(prop: vtkProp, casts: bool) -> None:
    """Say whether `prop` casts shadows. True also makes a translucent prop cast, as if opaque.

    >>> vtkshadows.set_casts_shadows(floor_actor, False)
    """
    vtkShadowPass.SetCastsShadows(_find.check_prop(prop), bool(casts))


def set_receives_shadows(prop: vtkProp, receives: bool) -> None:
    """Say whether `prop` receives shadows. False: it is always lit.

    >>> vtkshadows.set_receives_shadows(label_actor, False)
    """
    vtkShadowPass.SetReceivesShadows(_find.check_prop(prop), bool(receives))


def set_shadow_catcher(
    actor: vtkActor,
    catches: bool = True,
    color: Any = None,
    strength: Optional[float] = None,
    fade: Optional[float] = None,
) -> None:
    """Make `actor` show nothing but the shadow that falls on it, or an ordinary actor again.

    A catcher always receives, by every technique, and never casts. Its property gets the opacity 0, so
    that without shadows it shows nothing at all, and picking passes through it; made ordinary again it
    is opaque. Its property must be its own. What its alpha is: see vtkShadowPass::SetShadowCatcher.

    Parameters
    ----------
    color : of the shadow, red, green and blue from 0 to 1. Left out, here as below: as it was, at first
        black.
    strength : 0 (nothing) to 1, what the shadow's alpha is multiplied by; at first 1.
    fade : 0 to 1, share of the way from the rim to the middle on which the shadow rises to its whole
        strength; at first 0.

    Raises
    ------
    ValueError : an argument is out of range; nothing was changed.

    Example
    -------
    >>> vtkshadows.set_shadow_catcher(ground_actor, strength=0.6)
    """
    if not isinstance(actor, vtkActor):
        raise ValueError(f"{_find.kind(actor)} is not a vtkActor; give an actor")
    _floors.set_catcher(actor, catches, *_floors.check_catcher(color, strength, fade))


def set_smooth_cone(renderer: Any, light: Union[vtkLight, int], share: float) -> None:
    """Let a spot light fall off softly over a share of its cone's angle, 0 (at once) to 1, before its side.

    Between (1 - share) of the angle and the side it is the smoothstep of the angle's cosine. It multiplies
    the light's colour, whatever its technique, and is no part of `visibility`. See
    vtkShadowPass::SetLightSmoothCone.

    Raises
    ------
    ValueError : no such light, the share is out of range, or shadows are not enabled here (technique
        "none" will do).
    RuntimeError : the light is no spot; VTK's message.

    >>> vtkshadows.set_smooth_cone(renderer, 0, 0.3)
    """
    renderer = _find.renderer_of(renderer)
    shadows = _find.require_shadow_pass(renderer)
    light = _find.light_of(renderer, light)
    share = _checks.number("share", share, 0, 1)
    with _errors.VtkErrors(shadows):
        shadows.SetLightSmoothCone(light, share)


def set_light_texture(
    renderer: Any, light: Union[vtkLight, int], image: Any, up: Any = None
) -> Optional[vtkTexture]:
    """Let a spot light project an image, as a slide projector does; None: no more.

    The image covers the square around the circle of the light's cone; its colours multiply the light's,
    whatever its technique, and are no part of `visibility`. See vtkShadowPass::SetLightTexture.

    Parameters
    ----------
    image : a vtkTexture, a vtkImageData, the name of a .png file, or a NumPy array of bytes, (height,
        width) or (height, width, 3 or 4), row 0 at the top.
    up : three numbers, world: what is up in the image, as the light sees it. Left out: as it was, at first
        (0, 0, 1).

    Returns
    -------
    The texture, for its settings of interpolation and colour.

    Raises
    ------
    ValueError : no such light, no image, or shadows are not enabled here (technique "none" will do).
    RuntimeError : the light is no spot; VTK's message.

    >>> vtkshadows.set_light_texture(renderer, 0, "window.png")
    """
    renderer = _find.renderer_of(renderer)
    shadows = _find.require_shadow_pass(renderer)
    light = _find.light_of(renderer, light)
    texture = _images.texture_of(image)
    if up is not None:
        up = [_checks.finite("up", each) for each in _checks.vector("up", up)]
        if not any(up):
            raise ValueError("up: (0, 0, 0) is no direction; give the way that is up in the image")
    with _errors.VtkErrors(shadows):
        shadows.SetLightTexture(light, texture)
    with _errors.VtkErrors(shadows):
        if up is not None:
            shadows.SetLightTextureUp(light, *up)
    return texture


def add_floor(
    renderer: Any,
    shadow: Optional[str] = None,
    catcher: bool = True,
    normal: Any = "auto",
    offset: Optional[float] = None,
    size: float = 3.0,
    color: Any = None,
    strength: Optional[float] = None,
    fade: Optional[float] = None,
    light: bool = True,
) -> vtkActor:
    """Ground a figure: add a floor under what `renderer` shows, now, and give its lights shadows.

    Called again, it fits anew and changes the floor that it made.

    Parameters
    ----------
    shadow : one of techniques(), which every light then has, as by `enable`. Left out: shadows are left
        as they are; without any, a floor that catches shows nothing.
    catcher : True (default): it shows nothing but the shadow; see `set_shadow_catcher`. False: a plain
        floor, that casts and receives as any actor does.
    normal : the direction that it faces, three numbers (world). "auto" (default): the axis nearest to
        the view-up of the renderer's camera.
    offset : it lies in the plane n.x = offset (world units, n the normal of length 1). Left out: under
        the lowest point, by a 2000th of the scene's size.
    size : above 0 (3): side of the square, in units of the longest side of the scene's box.
    color : red, green and blue from 0 to 1: of the shadow (black), or of a plain floor (light grey).
    strength : 0 to 1 (1): what the shadow's alpha is multiplied by. Only of a catcher.
    fade : 0 to 1 (0.25): share of the way from the rim to the middle on which the shadow rises to its
        whole strength. Only of a catcher.
    light : True (default): if `shadow` is given and no light is on but headlights, which cast no shadow
        that is seen, add a directional light from above and left of the camera, and turn the headlights
        down to a third. False: leave the lights, with a warning if there is none that casts.

    A catcher does not count in the renderer's bounds (UseBoundsOff), so that resetting the camera frames
    the figure; nor does the camera's clipping range cut it. A plain floor counts.

    Returns
    -------
    The floor's actor.

    Raises
    ------
    ValueError : an argument is unknown or out of range; nothing was changed.
    RuntimeError : there is nothing to fit a floor to; VTK's message.

    Example
    -------
    >>> floor = vtkshadows.add_floor(renderer, shadow="depth-map", strength=0.7)
    """
    renderer = _find.renderer_of(renderer)
    if shadow is not None:
        _check_technique(shadow)
    if not catcher and (strength is not None or fade is not None):
        raise ValueError("strength and fade are a catcher's; leave them out where catcher is False")
    size = _checks.number("size", size, 0)
    if size == 0:
        raise ValueError("size: 0 is out of range; give more than 0")
    if offset is not None:
        offset = _checks.finite("offset", offset)
    normal = (0.0, 0.0, 0.0) if isinstance(normal, str) and normal == "auto" else _floors.direction_of(normal)
    color, strength, fade = _floors.check_catcher(color, strength, fade)

    floor = getattr(renderer, "_vtkshadows_floor", None) or vtkShadowFloor()
    floor.SetNormal(normal)
    floor.SetSize(size)
    with _errors.VtkErrors(None, floor) as errors:
        errors.require(floor.Fit(renderer) if offset is None else floor.FitAt(renderer, offset))
    renderer._vtkshadows_floor = floor  # to be found again
    actor = floor.GetActor()
    if catcher:
        _floors.set_catcher(
            actor,
            True,
            (0.0, 0.0, 0.0) if color is None else color,
            1.0 if strength is None else strength,
            0.25 if fade is None else fade,
        )
    else:
        _floors.set_catcher(actor, False)
        actor.GetProperty().SetColor((0.9, 0.9, 0.9) if color is None else color)
    actor.SetUseBounds(not catcher)
    if not renderer.HasViewProp(actor):
        renderer.AddActor(actor)

    if shadow is not None:
        enable(renderer, shadow)
    if shadow not in (None, "none") and not _floors.has_casting_light(renderer):
        if light:
            _floors.add_key_light(renderer, _floors.normal_of(actor))
        else:
            warnings.warn(
                "this renderer has no light but headlights, which cast no shadow that is seen: add a "
                "vtkLight, or leave light=False out",
                stacklevel=2,
            )
    return actor


def screenshot(window: Any, path: Any, transparent: bool = True) -> None:
    """Render, and write the picture as a PNG: with alpha, or as the window shows it.

    Transparent is what no prop covers, whatever the background. The colour is straight, not multiplied
    by alpha, and right over a page of any colour. It takes two frames, over black and over white; see
    vtkShadowMatte.

    Parameters
    ----------
    window : a vtkRenderWindow, a renderer in one, or a PyVista plotter.
    path : the file, whose name must end in .png.

    Raises
    ------
    ValueError : no window, or another format: of the usual ones only PNG keeps alpha and loses nothing.
    OSError : the file cannot be written.
    RuntimeError : VTK refused; its message.

    Example
    -------
    >>> vtkshadows.screenshot(window, "figure.png")
    """
    window = _find.window_of(window)
    path = os.fspath(path)
    if os.path.splitext(path)[1].lower() != ".png":
        raise ValueError(f"path: {path!r} is no .png file; a picture with alpha must be one")
    if transparent:
        image, matte = vtkImageData(), vtkShadowMatte()
        with _errors.VtkErrors(None, matte) as errors:
            errors.require(matte.Grab(window, image))
    else:
        window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        image = grab.GetOutput()
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.WriteToMemoryOn()
    writer.Write()
    with open(path, "wb") as file:
        file.write(vtk_to_numpy(writer.GetResult()).tobytes())


def set_stand_in(prop: vtkProp, polydata: Optional[vtkPolyData]) -> None:
    """Let another mesh cast in place of `prop`: a decimated one, or a hull. None: the prop itself, again.

    The mesh (a vtkPolyData, so PyVista's too) is in the prop's own coordinates and moves with it. All
    techniques use it but "ray-cast", which is the truth that `error` holds them against. The prop receives
    the mesh's shadow as any other does: where it lies inside of the mesh, it is dark.

    >>> vtkshadows.set_stand_in(actor, decimate.GetOutput())
    """
    if not (polydata is None or isinstance(polydata, vtkPolyData)):
        raise ValueError(f"{_find.kind(polydata)} is not a vtkPolyData; give a mesh, or None")
    vtkShadowPass.SetStandIn(_find.check_prop(prop), polydata)


def _check_technique(technique):
    known = techniques()
    if technique not in known:
        raise ValueError(f"unknown technique {technique!r}; there are {', '.join(known)}")
