"""VTK's errors as exceptions."""

import re
from typing import Any, List, Optional

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING

from .vtkShadowsPasses import vtkShadowPass


class VtkErrors:
    """While it lasts, errors of a vtkShadowPass, if any, and of `others` are collected, not displayed.

    At its end the first one is raised as a RuntimeError.
    """

    def __init__(self, shadows: Optional[vtkShadowPass], *others: Any):
        parts = [shadows, *others]
        if shadows is not None:
            parts += [
                shadows.GetDepthShadowMapPass(),
                shadows.GetObjectIDShadowPass(),
                shadows.GetPlanarShadowPass(),
                shadows.GetShadowTexturePass(),
                shadows.GetStencilShadowVolumePass(),
                shadows.GetRayCastShadowPass(),
                shadows.GetScene(),
            ]
        self._objects = [each for each in parts if each is not None]
        self._messages: List[str] = []

    def require(self, done: bool) -> None:
        """Note a call that failed without saying why."""
        if not done and not self._messages:
            self._messages.append("VTK could not do it, and did not say why")

    def __enter__(self) -> "VtkErrors":
        @calldata_type(VTK_STRING)
        def collect(caller, event, message):
            self._messages.append(plain_message(message))

        self._tags = [(each, each.AddObserver("ErrorEvent", collect)) for each in self._objects]
        return self

    def __exit__(self, kind, value, traceback) -> None:
        for each, tag in self._tags:
            each.RemoveObserver(tag)
        if kind is None and self._messages:
            raise RuntimeError(self._messages[0])


def plain_message(message: str) -> str:
    """VTK's message without file, line and address: "ERROR: In f.cxx, line 1\\nvtkX (0x1): text"."""
    text = re.sub(r"^(ERROR|Warning): In .*, line \d+\n", "", message).strip()
    return re.sub(r"^(\w+) \(0x[0-9a-f]+\): ", r"\1: ", text)
