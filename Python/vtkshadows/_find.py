"""What is meant by a renderer, a window, a light or a prop, and what is in them."""

import operator
from typing import Any, List, Optional, Union

import numpy

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight, vtkProp, vtkRenderer, vtkRenderWindow

from .vtkShadowsPasses import vtkShadowPass


def window_of(thing: Any) -> vtkRenderWindow:
    if isinstance(thing, vtkRenderWindow):
        return thing
    if isinstance(thing, vtkRenderer):
        window = thing.GetRenderWindow()
    else:
        window = getattr(thing, "render_window", None) or getattr(thing, "ren_win", None)
    if not isinstance(window, vtkRenderWindow):
        raise ValueError(f"{kind(thing)} is no vtkRenderWindow and is in none; give the window itself")
    return window


def names_from(fill: Any) -> List[str]:
    names = vtkStringArray()
    fill(names)
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())]


def kind(thing: Any) -> str:
    return type(thing).__name__


def renderer_of(thing: Any) -> vtkRenderer:
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
        raise ValueError(f"{kind(thing)} has {len(several)} renderers; give one of them")
    raise ValueError(f"{kind(thing)} is not a vtkRenderer and has none; give the renderer itself")


def shadow_pass_of(renderer: vtkRenderer) -> Optional[vtkShadowPass]:
    shadows = renderer.GetPass()
    return shadows if isinstance(shadows, vtkShadowPass) else None


def require_shadow_pass(renderer: vtkRenderer) -> vtkShadowPass:
    shadows = shadow_pass_of(renderer)
    if shadows is None:
        raise ValueError("this renderer has no shadows; call vtkshadows.enable(renderer) first")
    return shadows


def switched_on_lights(renderer: vtkRenderer) -> List[vtkLight]:
    return [each for each in renderer.GetLights() if each.GetSwitch()]


def light_of(renderer: vtkRenderer, light: Union[vtkLight, int]) -> vtkLight:
    if isinstance(light, vtkLight):
        if not renderer.GetLights().IsItemPresent(light):
            raise ValueError("light: not one of this renderer's; add it with AddLight")
        return light
    switched_on = switched_on_lights(renderer)
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


def check_prop(prop: Any) -> vtkProp:
    if not isinstance(prop, vtkProp):
        raise ValueError(f"{kind(prop)} is not a vtkProp; give an actor")
    return prop


def image_to_numpy(image: vtkImageData) -> numpy.ndarray:
    """The scalars of a 2D image as (height, width[, components]), row 0 at the top."""
    width, height, _ = image.GetDimensions()
    scalars = vtk_to_numpy(image.GetPointData().GetScalars())
    shape = (height, width) + scalars.shape[1:]
    # VTK's rows go up from the bottom. A copy: the image dies with the call.
    return numpy.array(scalars.reshape(shape)[::-1], order="C")
