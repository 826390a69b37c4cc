"""The plugin's test scene: a sphere floats over a plane, seen straight from above with +y up.

Light comes down from +x and +y, so that the shadow falls toward -x, -y: to the left and down.
"""
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SIZE = (400, 300)
PER_UNIT = SIZE[1] / 2 / 3  # pixels a world unit: the parallel scale is 3

simple._DisableFirstRenderCameraReset()
SOURCES = [
    simple.Sphere(Center=(0, 0, 1.5), Radius=0.4, ThetaResolution=48, PhiResolution=48),
    simple.Plane(Origin=(-5, -5, 0), Point1=(5, -5, 0), Point2=(-5, 5, 0)),
]


def pixel(x, y):
    return int(SIZE[1] / 2 - y * PER_UNIT), int(SIZE[0] / 2 + x * PER_UNIT)


def near(frame, x, y):
    """The 5 x 5 pixels around a point of the plane."""
    row, column = pixel(x, y)
    return frame[row - 2 : row + 3, column - 2 : column + 3].astype(int)


def make_view(kind):
    view = simple.CreateView(kind)
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    view.UseLight = 0  # the light kit
    view.UseFXAA = 0
    view.CameraParallelProjection = 1
    view.CameraPosition = (0, 0, 10)
    view.CameraFocalPoint = (0, 0, 0)
    view.CameraViewUp = (0, 1, 0)
    view.CameraParallelScale = 3
    for source in SOURCES:
        display = simple.Show(source, view)
        display.ColorArrayName = [None, ""]
        display.DiffuseColor = (0.7, 0.7, 0.7)
        display.Specular = 0
    return view


def add_light(view):
    light = simple.AddLight(view)
    light.Position = (1, 1, 1)
    light.FocalPoint = (0, 0, 0)
    return light


def screenshot(view, path):
    """The view as bytes (height, width, 3), row 0 at the top; also kept as a PNG file."""
    simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)
    return read(path)


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[::-1, :, :3]
