"""Exact shadows of a broken mesh: a Moebius strip of which every second triangle is missing.

Writes stencil_volumes.png and stencil_volumes-explained.png, or the files that are named.
"""
import sys

import vtkshadows
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricMobius
from vtkmodules.vtkFiltersCore import vtkMaskPolyData
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

floor, body = vtkPlaneSource(), vtkParametricFunctionSource()
floor.SetOrigin(-3, -3, -1)
floor.SetPoint1(3, -3, -1)
floor.SetPoint2(-3, 3, -1)
body.SetParametricFunction(vtkParametricMobius())  # a strip with one side: none of it faces outward
body.SetUResolution(32)
body.SetVResolution(6)
broken = vtkMaskPolyData()
broken.SetInputConnection(body.GetOutputPort())
broken.SetOnRatio(2)

renderer, window, light = vtkRenderer(), vtkRenderWindow(), vtkLight()
for mesh in (floor, broken):
    actor, mapper = vtkActor(), vtkPolyDataMapper()
    mapper.SetInputConnection(mesh.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.3)
    actor.GetProperty().SetDiffuse(0.6)
    renderer.AddActor(actor)
light.SetPosition(1, 0.6, 2)  # directional: from there toward the origin
renderer.AddLight(light)
renderer.SetBackground(1, 1, 1)
renderer.GetActiveCamera().SetPosition(-2, -5, 3)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCamera()
renderer.GetActiveCamera().Zoom(1.5)
window.SetSize(800, 600)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)

files = sys.argv[1:3] or ["stencil_volumes.png", "stencil_volumes-explained.png"]
for file, view in zip(files, ("none", "volumes")):
    vtkshadows.enable(renderer, technique="stencil-volume", debug_view=view)
    window.Render()
    grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    grab.SetInput(window)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()
counts = vtkshadows.volume_counts(renderer)
print(f"most layers over a pixel: {counts[vtkshadows.visibility(renderer) < 0.5].max()}")
