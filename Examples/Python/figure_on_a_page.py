"""A figure that stands on the page: writes figure_on_a_page.png, transparent but for it and its shadow."""
import sys

import vtkshadows
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

torus, mapper, actor = vtkSuperquadricSource(), vtkPolyDataMapper(), vtkActor()
torus.ToroidalOn()
torus.SetThetaResolution(96)
torus.SetPhiResolution(48)
mapper.SetInputConnection(torus.GetOutputPort())
actor.SetMapper(mapper)
actor.RotateX(50)
actor.GetProperty().SetColor(0.9, 0.5, 0.3)

renderer, window = vtkRenderer(), vtkRenderWindow()
renderer.AddActor(actor)
window.SetSize(800, 600)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)
renderer.ResetCamera()
renderer.GetActiveCamera().Elevation(25)

# A catcher under it, y up as the camera has it, and a light that casts: VTK's own is a headlight.
vtkshadows.add_floor(renderer, shadow="stencil-volume", strength=0.8)
vtkshadows.enable(renderer, "stencil-volume", radius=0.08)
vtkshadows.screenshot(window, sys.argv[1] if len(sys.argv) > 1 else "figure_on_a_page.png")
