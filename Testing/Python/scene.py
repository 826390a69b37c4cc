"""The tests' scene: a sphere over a floor in the plane z = 0, seen from above, lit by one light."""
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

SIZE = (320, 240)


def _add_actor(renderer, source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    return actor


class Scene:
    """Light comes down from +x, +y (45 degrees each): the shadow falls toward -x and -y.

    The camera looks straight down with +y up, so that in a picture whose row 0 is at the top the shadow
    lies to the left of the sphere and below it.
    """

    def __init__(self):
        sphere = vtkSphereSource()
        sphere.SetCenter(0, 0, 1.5)
        sphere.SetRadius(0.4)
        sphere.SetPhiResolution(48)
        sphere.SetThetaResolution(48)
        floor = vtkPlaneSource()
        floor.SetOrigin(-5, -5, 0)
        floor.SetPoint1(5, -5, 0)
        floor.SetPoint2(-5, 5, 0)

        self.renderer = vtkRenderer()
        self.sphere = _add_actor(self.renderer, sphere)
        self.floor = _add_actor(self.renderer, floor)
        self.light = self.add_light((1, 1, 1))

        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetPosition(0, 0, 10)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 1, 0)
        camera.SetParallelScale(3)
        self.renderer.ResetCameraClippingRange()

        self.window = vtkRenderWindow()
        self.window.SetSize(*SIZE)
        self.window.SetMultiSamples(0)
        self.window.OffScreenRenderingOn()
        self.window.AddRenderer(self.renderer)

    def add_light(self, toward):
        light = vtkLight()
        light.SetPosition(*toward)
        light.SetFocalPoint(0, 0, 0)
        self.renderer.AddLight(light)
        return light

    def frame(self):
        """Render, and the frame as bytes (height, width, 3), row 0 at the top."""
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        pixels = vtk_to_numpy(image.GetPointData().GetScalars())
        return pixels.reshape(height, width, -1)[::-1].copy()

    def pixel(self, x, y):
        """(row, column) of the world position (x, y, 0), row 0 at the top."""
        width, height = SIZE
        per_unit = height / 2 / self.renderer.GetActiveCamera().GetParallelScale()
        return int(height / 2 - y * per_unit), int(width / 2 + x * per_unit)
