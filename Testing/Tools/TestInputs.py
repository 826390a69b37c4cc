"""The files that are read: each makes a picture of as many triangles as it has, and the floor's two."""

import base64
import json
import os
import struct

from commandtest import check, enter_empty_folder, finish, succeed, write_off, write_tetrahedron

FLOOR = 2


def triangles(*arguments):
    out = succeed("render", *arguments, "-o", "picture.png", "--size", "64x48")
    words = out.split()
    return int(words[1]) - FLOOR if len(words) > 2 else -1


def write(path, content):
    with open(path, "wb" if isinstance(content, bytes) else "w") as file:
        file.write(content)


enter_empty_folder()
write_tetrahedron("tetrahedron.off")
POINTS = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
FACES = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"
FLAT_POINTS = POINTS.replace("\n", " ")

# OFF, as it is found: comments, the counts on the first line, colours, normals, no keyword, CRLF.
off_files = {
    "plain": "OFF\n4 4 0\n" + POINTS + FACES,
    "comments": "# by hand\nOFF # this\n\n4 4 0 # counts\n" + POINTS.replace("\n", " # p\n") + FACES,
    "one-line": "OFF 4 4 6\n" + POINTS + FACES,
    "colours": "COFF\n4 4 0\n" + POINTS.replace("\n", " 255 0 0 255\n") + FACES.replace("\n", " 0.5 0.5 0.5\n"),
    "normals": "NOFF\n4 4 0\n" + POINTS.replace("\n", " 0 0 1\n") + FACES,
    "bare": "4 4 0\n" + POINTS + FACES,
    "crlf": ("OFF\n4 4 0\n" + POINTS + FACES).replace("\n", "\r\n"),
    "segments-too": "OFF\n4 6 0\n" + POINTS + FACES + "2 0 1\n1 3\n",
}  # fmt: skip
for name, content in off_files.items():
    write(f"{name}.off", content)
    check(f"triangles of {name}.off", triangles(f"{name}.off"), 4)

# Polygons are cut into triangles.
pentagon = [(0, 0, 0), (2, 0, 0), (2, 1, 1), (1, 2, 1), (0, 1, 1)]
write_off("pentagon.off", pentagon, [(0, 1, 2, 3, 4)])
check("triangles of a pentagon", triangles("pentagon.off"), 3)

write("mesh.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
      + POINTS + FACES)  # fmt: skip
write("mesh.obj", "".join(f"v {line}\n" for line in POINTS.splitlines())
      + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n")  # fmt: skip
corners = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
places = [tuple(map(float, line.split())) for line in POINTS.splitlines()]
write("mesh.stl", b"\0" * 80 + struct.pack("<I", 4) + b"".join(
    struct.pack("<12fH", 0, 0, 0, *(x for corner in face for x in places[corner]), 0)
    for face in corners))  # fmt: skip
write("mesh.vtk", "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
      + POINTS + "POLYGONS 4 16\n" + FACES)  # fmt: skip
INDICES = "0 2 1 0 1 3 1 2 3 0 3 2"
write("mesh.vtp", f"""<VTKFile type="PolyData" version="1.0"><PolyData>
<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="4">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">{FLAT_POINTS}</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">{INDICES}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 6 9 12</DataArray></Polys>
</Piece></PolyData></VTKFile>""")
write("mesh.vtu", f"""<VTKFile type="UnstructuredGrid" version="1.0"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="1">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">{FLAT_POINTS}</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>""")
buffer = struct.pack("<12f", *(x for place in places for x in place)) + struct.pack(
    "<12H", *map(int, INDICES.split()))  # fmt: skip
write("mesh.gltf", json.dumps({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0}, {"mesh": 0, "translation": [3, 0, 0]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "buffers": [{"byteLength": len(buffer),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(buffer).decode()}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                   "min": [0, 0, 0], "max": [1, 1, 1]},
                  {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
}))  # fmt: skip
for extension, count in [("ply", 4), ("obj", 4), ("stl", 4), ("vtk", 4), ("vtp", 4), ("vtu", 4), ("gltf", 8)]:
    check(f"triangles of mesh.{extension}", triangles(f"mesh.{extension}"), count)

# An image is contoured: at the isovalue, else at the middle. A corner of 2x2x2 that differs is cut off by
# one triangle.
write("image.vti", """<VTKFile type="ImageData" version="1.0">
<ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 1 0 1 0 1">
<PointData Scalars="s"><DataArray type="Float32" Name="s" format="ascii">10 0 0 0 0 0 0 0</DataArray>
</PointData></Piece></ImageData></VTKFile>""")
check("triangles of an image at its middle", triangles("image.vti"), 1)
check("triangles of an image at an isovalue", triangles("image.vti", "--isovalue", 9), 1)

# Several at once; an extension in capitals.
os.rename("mesh.stl", "MESH.STL")
check("triangles of three inputs", triangles("mesh.ply", "MESH.STL", "image.vti"), 9)
check("triangles without a floor", triangles("mesh.ply", "--floor", "none"), 4 - FLOOR)

finish()
