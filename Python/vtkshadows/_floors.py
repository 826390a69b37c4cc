"""Floors, catchers, and the light that shows them."""

from typing import Any, List

import numpy

from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight

from . import _checks, _find
from .vtkShadowsPasses import vtkShadowPass


def check_catcher(color, strength, fade):
    return (
        None if color is None else [_checks.number("color", each, 0, 1) for each in _checks.vector("color", color)],
        None if strength is None else _checks.number("strength", strength, 0, 1),
        None if fade is None else _checks.number("fade", fade, 0, 1),
    )


def set_catcher(actor, catches, color=None, strength=None, fade=None):
    vtkShadowPass.SetShadowCatcher(actor, bool(catches))
    if not catches:
        return
    if color is not None:
        vtkShadowPass.SetCatcherColor(actor, *color)
    if strength is not None:
        vtkShadowPass.SetCatcherStrength(actor, strength)
    if fade is not None:
        vtkShadowPass.SetCatcherFade(actor, fade)


def direction_of(value: Any) -> List[float]:
    if isinstance(value, str):
        raise ValueError(f"normal: {value!r} is not known; give 'auto' or three numbers")
    direction = [_checks.finite("normal", each) for each in _checks.vector("normal", value)]
    if not any(direction):
        raise ValueError("normal: (0, 0, 0) is no direction; give the way the floor faces")
    return direction


def has_casting_light(renderer):
    return any(not each.LightTypeIsHeadlight() for each in _find.switched_on_lights(renderer))


def normal_of(actor):
    matrix = actor.GetUserMatrix()
    normal = numpy.array([matrix.GetElement(row, 2) for row in range(3)])
    return normal / numpy.linalg.norm(normal)


def add_key_light(renderer, up):
    """From above and left of the camera, a little from before it; headlights are left to fill."""
    if renderer.GetAutomaticLightCreation() and not _find.switched_on_lights(renderer):
        headlight = vtkLight()  # as VTK does in the first frame
        headlight.SetLightTypeToHeadlight()
        renderer.AddLight(headlight)
    for each in _find.switched_on_lights(renderer):
        each.SetIntensity(each.GetIntensity() / 3)
    # Not the renderer's own if it has none yet: VTK resets the one that it makes in its first frame.
    camera = renderer.GetActiveCamera() if renderer.IsActiveCameraCreated() else vtkCamera()
    back, above = (numpy.array(v) for v in (camera.GetViewPlaneNormal(), camera.GetViewUp()))
    left = numpy.cross(back, above)
    left = left - left.dot(up) * up
    if numpy.linalg.norm(left) < 1e-6:
        left = numpy.cross(up, back)  # a camera that lies on its side
    left /= numpy.linalg.norm(left)
    front = numpy.cross(up, left)
    front *= 1 if front.dot(back) >= 0 else -1
    light = vtkLight()
    light.SetPosition(*(up + 0.55 * left + 0.5 * front))
    light.SetFocalPoint(0, 0, 0)
    light.SetIntensity(0.8)
    renderer.AddLight(light)
