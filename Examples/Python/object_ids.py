"""Shadows by object IDs: plates of one mesh, told apart as connected pieces, shadow each other.

With a depth beside each ID every shadow is there, whatever is an object; with IDs alone no object has a
shadow on itself. Writes object_ids.png and object_ids-alone.png (all of the mesh one object, IDs alone), or
the files that are named.
"""
import sys

import vtkshadows
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

stair = vtkAppendPolyData()  # one mesh of five plates, each half over the next
for i in range(5):
    plate = vtkCubeSource()
    plate.SetBounds(i, i + 2, -1, 1, -0.8 * i, 0.1 - 0.8 * i)
    stair.AddInputConnection(plate.GetOutputPort())

renderer, window, light = vtkRenderer(), vtkRenderWindow(), vtkLight()
actor, mapper = vtkActor(), vtkPolyDataMapper()
mapper.SetInputConnection(stair.GetOutputPort())
actor.SetMapper(mapper)
actor.GetProperty().SetAmbient(0.3)
actor.GetProperty().SetDiffuse(0.6)
renderer.AddActor(actor)
light.SetPosition(-0.5, -0.4, 2)  # directional: from there toward the origin
renderer.AddLight(light)
renderer.SetBackground(1, 1, 1)
renderer.GetActiveCamera().SetPosition(8, -8, 8)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCamera()
renderer.GetActiveCamera().Zoom(1.4)
window.SetSize(800, 600)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)

files = sys.argv[1:3] or ["object_ids.png", "object_ids-alone.png"]
for kind, depths, file in (("piece", True, files[0]), ("piece", False, None), ("prop", False, files[1])):
    vtkshadows.enable(renderer, technique="object-id", object_type=kind, object_depth=depths)
    window.Render()
    dark = 100 * (vtkshadows.visibility(renderer) < 0.5).mean()
    print(f"{kind}, depths {'on' if depths else 'off'}: {dark:5.2f} % in shadow")
    if file:
        grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
        grab.SetInput(window)
        writer.SetInputConnection(grab.GetOutputPort())
        writer.SetFileName(file)
        writer.Write()
