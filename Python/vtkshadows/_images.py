"""Images that lights project."""

import os
from typing import Any, Optional

import numpy

from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkTexture

from . import _errors, _find


def texture_of(image: Any) -> Optional[vtkTexture]:
    if image is None or isinstance(image, vtkTexture):
        return image
    texture = vtkTexture()
    texture.InterpolateOn()
    if isinstance(image, vtkImageData):
        texture.SetInputData(image)
    elif isinstance(image, numpy.ndarray):
        texture.SetInputData(image_of_pixels(image))
    else:
        texture.SetInputData(read_png(image))
    return texture


def image_of_pixels(pixels: numpy.ndarray) -> vtkImageData:
    shape = pixels.shape if pixels.ndim == 3 else (*pixels.shape, 1)
    if pixels.ndim not in (2, 3) or pixels.dtype != numpy.uint8 or shape[2] not in (1, 3, 4) or 0 in shape:
        raise ValueError(
            f"image: an array of shape {pixels.shape} and type {pixels.dtype} is none; give uint8, "
            "(height, width) or (height, width, 3 or 4)"
        )
    image = vtkImageData()
    image.SetDimensions(shape[1], shape[0], 1)
    # VTK's rows go up from the bottom.
    rows = numpy.ascontiguousarray(pixels[::-1]).reshape(-1, shape[2])
    image.GetPointData().SetScalars(numpy_to_vtk(rows, deep=True))
    return image


def read_png(path: Any) -> vtkImageData:
    try:
        path = os.fspath(path)
    except TypeError:
        raise ValueError(
            f"image: {_find.kind(path)} is none; give a vtkTexture, a vtkImageData, an array or a .png file"
        ) from None
    reader = vtkPNGReader()
    if not os.path.isfile(path) or not reader.CanReadFile(path):
        raise ValueError(f"image: {path!r} is no .png file that can be read; give another, or an array")
    reader.SetFileName(path)
    with _errors.VtkErrors(None, reader):
        reader.Update()
    return reader.GetOutput()
