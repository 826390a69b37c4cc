"""How much ground a mesh shades, from noon to evening, without a window.

Writes the last shadow's outline to shadow_outline.vtp, or to the file that is named.
"""
import math
import sys

import vtkshadows
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

mesh = vtkSuperquadricSource()  # a ring
mesh.ToroidalOn()
mesh.SetPhiResolution(64)
mesh.SetThetaResolution(64)

shadow = vtkshadows.vtkPlanarShadowFilter()
shadow.SetInputConnection(mesh.GetOutputPort())
shadow.SetPlaneOrigin(0, -1, 0)  # the ground
shadow.SetPlaneNormal(0, 1, 0)
shadow.SetOutputModeToOutline()
for degrees in (90, 75, 60, 45, 30, 15):
    height = math.radians(degrees)
    shadow.SetLight(math.cos(height), math.sin(height), 0, 0)  # the direction toward the sun
    shadow.Update()
    outline = shadow.GetOutput()
    area = outline.GetFieldData().GetArray("ShadowArea").GetValue(0)
    print(f"sun at {degrees} degrees: shadow {area:.4f}, {outline.GetNumberOfLines()} loops")

writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(shadow.GetOutputPort())
writer.SetDataModeToBinary()  # its default, appended data, VTK before 9.4 cannot read by a recent expat
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "shadow_outline.vtp")
writer.Write()
