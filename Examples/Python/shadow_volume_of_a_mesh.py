"""The shadow of a mesh as data, without a window: how long its silhouette is, how large its volume.

Writes shadow_volume.vtp, or the file that is named.
"""
import sys

import numpy
import vtkshadows
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

mesh = vtkSuperquadricSource()
mesh.SetPhiResolution(64)
mesh.SetThetaResolution(64)

silhouette, volume = vtkshadows.vtkShadowSilhouetteFilter(), vtkshadows.vtkShadowVolumeFilter()
for shadow in (silhouette, volume):
    shadow.SetInputConnection(mesh.GetOutputPort())
    shadow.SetLightPosition(1, 2, 3)
volume.SetExtentModeToLength()
volume.SetLength(2)  # each point is carried two units away from the light
silhouette.Update()
volume.Update()

lines, hull = silhouette.GetOutput(), volume.GetOutput()
ends = vtk_to_numpy(lines.GetLines().GetConnectivityArray()).reshape(-1, 2)
start, end = vtk_to_numpy(lines.GetPoints().GetData())[ends].transpose(1, 0, 2)
print(f"silhouette: {len(ends)} edges, length {numpy.linalg.norm(end - start, axis=1).sum():.3f}")
triangles = vtk_to_numpy(hull.GetPolys().GetConnectivityArray()).reshape(-1, 3)
a, b, c = vtk_to_numpy(hull.GetPoints().GetData())[triangles].transpose(1, 0, 2)
print(f"volume: {len(triangles)} triangles hold {(a * numpy.cross(b, c)).sum() / 6:.3f}")

writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(volume.GetOutputPort())
writer.SetDataModeToBinary()  # its default, appended data, VTK before 9.4 cannot read by a recent expat
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "shadow_volume.vtp")
writer.Write()
