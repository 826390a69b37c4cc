"""The shadow of a sphere on a plane: writes first_shadow.png, or the file that is named."""
import sys

import vtkshadows
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

plane, sphere = vtkPlaneSource(), vtkSphereSource()  # a unit square at z = 0
sphere.SetCenter(0, 0, 0.25)
sphere.SetRadius(0.15)
sphere.SetPhiResolution(64)
sphere.SetThetaResolution(64)

renderer, window = vtkRenderer(), vtkRenderWindow()
for source in (plane, sphere):
    actor, mapper = vtkActor(), vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    renderer.AddActor(actor)

light = vtkLight()  # a spot: positional, with a cone
light.SetPositional(True)
light.SetConeAngle(40)
light.SetPosition(0.6, 0.3, 1.2)
light.SetFocalPoint(0, 0, 0)
renderer.AddLight(light)
vtkshadows.enable(renderer, technique="depth-map", strength=0.8)

window.SetSize(800, 600)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)
renderer.GetActiveCamera().SetPosition(0, -2, 1.5)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCamera()
renderer.GetActiveCamera().Zoom(1.5)
renderer.SetBackground(1, 1, 1)
window.Render()
print(f"shadow: {100 * (vtkshadows.visibility(renderer) < 0.5).mean():.1f} % of the picture")

grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
grab.SetInput(window)
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "first_shadow.png")
writer.Write()
