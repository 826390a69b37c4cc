"""Meshes for the benchmarks: read from files, and made here to be hard.

A mesh is a vtkPolyData as its file has it: no welding, no triangulation, no normals, degenerate faces kept.
"""
import math
import pathlib
import re

import numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


class NoSurface(Exception):
    """The file was read, or is of a kind, that holds no surface; the message says what it is."""


# --- Reading -----------------------------------------------------------------------------------------


def read_mesh(path):
    """The surface in a file. Raises NoSurface, or ValueError for a file that cannot be read."""
    path = pathlib.Path(path)
    kind = path.suffix.lower()
    if kind not in _READERS:
        raise NoSurface(f"{kind or 'a file without extension'} is no surface format that is read")
    mesh = _READERS[kind](path)
    if mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0:
        points, lines = mesh.GetNumberOfPoints(), mesh.GetNumberOfLines()
        if points + lines == 0:
            raise ValueError(f"{path}: nothing in it could be read")
        raise NoSurface(f"it has no faces, only {points} points and {lines} lines")
    return mesh


def read_off(path):
    """An OFF file, by the rules of Tools/OffReader.cxx: one vertex or face a line.

    Any prefix of S, T, C and N, or no keyword; comments and blank lines anywhere; the counts on the
    keyword's line or below it; what follows a vertex's coordinates or a face's indices is left. Faces of
    fewer than three vertices are left out: a polygon cannot hold them.
    """
    lines = _off_lines(pathlib.Path(path).read_text(encoding="latin-1"))
    vertices, faces = _off_counts(path, lines)
    points = numpy.empty((vertices, 3))
    for i in range(vertices):
        points[i] = _off_numbers(path, lines, f"vertex {i}", float, 3)
    sizes, corners = [], []
    for i in range(faces):
        words = _off_words(path, lines, f"face {i}")
        size = _off_convert(path, words[:1], f"face {i}", int, 1)[0]
        face = _off_convert(path, words[1 : 1 + size], f"face {i}", int, size)
        if any(not 0 <= corner < vertices for corner in face):
            raise ValueError(f"{path}: face {i} names a vertex that is not one of {vertices}: {face}")
        if size >= 3:
            sizes.append(size)
            corners += face
    return polygons(points, sizes, corners)


def _off_lines(text):
    for line in text.split("\n"):
        words = line.split("#", 1)[0].split()
        if words:
            yield words


def _off_counts(path, lines):
    words = _off_words(path, lines, "the counts")
    if words[0].endswith("OFF"):
        if words[0][:-3].strip("STCN"):
            raise ValueError(f"{path}: {words[0]} has not three coordinates a vertex")
        if words[1:2] == ["BINARY"]:
            raise ValueError(f"{path}: BINARY is not read, only text")
        words = words[1:] or _off_words(path, lines, "the counts")
    vertices, faces = _off_convert(path, words[:2], "the counts", int, 2)
    if vertices < 0 or faces < 0:
        raise ValueError(f"{path}: counts of {vertices} vertices and {faces} faces")
    return vertices, faces


def _off_numbers(path, lines, what, kind, count):
    return _off_convert(path, _off_words(path, lines, what)[:count], what, kind, count)


def _off_words(path, lines, what):
    words = next(lines, None)
    if words is None:
        raise ValueError(f"{path}: the file ends before {what}")
    return words


def _off_convert(path, words, what, kind, count):
    try:
        numbers = [kind(word) for word in words]
    except ValueError:
        raise ValueError(f"{path}: {what}: {' '.join(words)} are no numbers") from None
    if len(numbers) != count:
        raise ValueError(f"{path}: {what} has {len(numbers)} of {count} numbers")
    return numbers


def _reading_with(reader_class):
    def read(path):
        messages = []

        @calldata_type(VTK_STRING)
        def collect(caller, event, message):
            messages.append(re.sub(r"^\w+ \(0x[0-9a-f]+\): ", "", message.strip().splitlines()[-1]))

        reader = reader_class()
        reader.AddObserver("ErrorEvent", collect)
        reader.SetFileName(str(path))
        reader.Update()
        if messages:
            raise ValueError(f"{path}: {messages[0]}")
        return reader.GetOutput()

    return read


_READERS = {
    ".off": read_off,
    ".ply": _reading_with(vtkPLYReader),
    ".stl": _reading_with(vtkSTLReader),
    ".obj": _reading_with(vtkOBJReader),
    ".vtp": _reading_with(vtkXMLPolyDataReader),
}


# --- Arrays and meshes -------------------------------------------------------------------------------


def polygons(points, sizes, corners):
    """A mesh of points (n, 3), the number of corners of each face, and all corners one after another."""
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(numpy.asarray(points, dtype=float), deep=True))
    offsets = numpy.concatenate(([0], numpy.cumsum(sizes, dtype=numpy.int64))).astype(numpy.int64)
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True),
        numpy_to_vtkIdTypeArray(numpy.asarray(corners, dtype=numpy.int64), deep=True),
    )
    mesh = vtkPolyData()
    mesh.SetPoints(coordinates)
    mesh.SetPolys(cells)
    return mesh


def triangles(points, faces):
    """A mesh of points (n, 3) and corners (m, 3)."""
    return polygons(points, [3] * len(faces), numpy.asarray(faces).ravel())


def arrays_of(mesh):
    """Points (n, 3) and corners (m, 3) of a mesh of triangles."""
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
    assert mesh.GetPolys().GetMaxCellSize() == 3, "a mesh of triangles"
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float), corners.reshape(-1, 3)


def triangle_count(mesh):
    count = 0
    for cells in (mesh.GetPolys(), mesh.GetStrips()):
        count += cells.GetNumberOfConnectivityIds() - 2 * cells.GetNumberOfCells()
    return count


def surface_points(mesh):
    """The finite points that faces use, (n, 3): those that decide how large a mesh looks."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    corners = [vtk_to_numpy(c.GetConnectivityArray()) for c in (mesh.GetPolys(), mesh.GetStrips())
               if c.GetNumberOfCells()]
    used = points[numpy.unique(numpy.concatenate(corners))]
    return used[numpy.isfinite(used).all(axis=1)]


# --- Made meshes -------------------------------------------------------------------------------------


def _lot():
    """Made meshes are the same in each run."""
    return numpy.random.default_rng(20)


def _grid(rows, columns, position, index):
    """Triangles between rows x columns quads; `index` glues their corners, `position` places them."""
    points, faces = {}, []
    for i in range(rows):
        for j in range(columns):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            a, b, c, d = (index(*corner) for corner in corners)
            faces += [(a, b, c), (a, c, d)]
            for corner in (a, b, c, d):
                points.setdefault(corner, position(*corner))
    number = {corner: n for n, corner in enumerate(points)}
    return triangles(list(points.values()), [[number[c] for c in face] for face in faces])


def moebius_strip():
    around, across = 90, 6

    def position(i, j):
        turn, off = 2 * math.pi * i / around, 0.45 * (2 * j / across - 1)
        radius = 1 + off * math.cos(turn / 2)
        return radius * math.cos(turn), radius * math.sin(turn), off * math.sin(turn / 2)

    return _grid(around, across, position, lambda i, j: (i, j) if i < around else (0, across - j))


def klein_bottle():
    """The figure-of-eight immersion: closed, one-sided, it meets itself along a circle."""
    around, across = 96, 48

    def position(i, j):
        u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
        c, s = math.cos(u / 2), math.sin(u / 2)
        radius = 2 + c * math.sin(v) - s * math.sin(2 * v)
        return radius * math.cos(u), radius * math.sin(u), s * math.sin(v) + c * math.sin(2 * v)

    return _grid(around, across, position,
                 lambda i, j: (i, j % across) if i < around else (0, -j % across))


def _sphere():
    source = vtkSphereSource()
    source.SetThetaResolution(36)
    source.SetPhiResolution(18)
    source.Update()
    return arrays_of(source.GetOutput())


def t_junctions():
    """A sphere; every other triangle is cut at the middle of an edge, and its neighbour there is not told."""
    points, faces = _sphere()
    points, cut = list(points), []
    for i, (a, b, c) in enumerate(faces):
        if i % 2:
            cut.append((a, b, c))
            continue
        points.append((points[a] + points[b]) / 2)
        middle = len(points) - 1
        cut += [(a, middle, c), (middle, b, c)]
    return triangles(points, cut)


def duplicated_triangles():
    """A sphere; half its triangles are there twice, a quarter three times, half of those turned over."""
    points, faces = _sphere()
    again = numpy.concatenate((faces[::2], faces[::4]))
    again[1::2] = again[1::2, ::-1]
    return triangles(points, numpy.concatenate((faces, again)))


def one_triangle():
    return triangles([(0, 0, 0), (1, 0.2, 0.4), (0.3, 0.9, 0.8)], [(0, 1, 2)])


def random_soup(count=10_000):
    lot = _lot()
    centres = lot.uniform(-1, 1, (count, 1, 3))
    corners = centres + lot.normal(0, 0.03, (count, 3, 3))
    return triangles(corners.reshape(-1, 3), numpy.arange(3 * count).reshape(-1, 3))


def stack_of_sheets(count=300):
    """More sheets than 8 bits count: squares over one another, each turned and shifted a little."""
    lot = _lot()
    points, faces = [], []
    for i in range(count):
        turn, (x, y) = lot.uniform(0, 0.3), lot.uniform(-0.1, 0.1, 2)
        first = len(points)
        for k in range(4):
            angle = turn + math.pi / 2 * k
            points.append((x + math.cos(angle), y + math.sin(angle), 0.005 * i))
        faces += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return triangles(points, faces)


def grass(blades=3000):
    """Thin slivers, bent once."""
    lot = _lot()
    points, faces = [], []
    for _ in range(blades):
        x, y, turn = *lot.uniform(-1, 1, 2), lot.uniform(0, 2 * math.pi)
        width, height, lean = lot.uniform(0.001, 0.006), lot.uniform(0.2, 0.7), lot.normal(0, 0.1, 2)
        across = numpy.array((math.cos(turn), math.sin(turn), 0)) * width
        root, bend = numpy.array((x, y, 0)), numpy.array((x + lean[0] / 3, y + lean[1] / 3, 0.6 * height))
        tip = numpy.array((x + lean[0], y + lean[1], height))
        n = len(points)
        points += [root - across, root + across, bend - across / 2, bend + across / 2, tip]
        faces += [(n, n + 1, n + 3), (n, n + 3, n + 2), (n + 2, n + 3, n + 4)]
    return triangles(points, faces)


ELEPHANT = "refined_elephant.off"


def _elephant(change):
    """A maker of an elephant whose points and faces are changed."""

    def make(folder):
        if not (folder / ELEPHANT).exists():
            raise NoSurface(f"it is made of {ELEPHANT}, which is not among the meshes")
        return triangles(*change(*arrays_of(read_off(folder / ELEPHANT))))

    return make


def _reversed(points, faces):
    return points, faces[:, ::-1]


def _randomly_flipped(points, faces):
    turned = _lot().random(len(faces)) < 0.5
    return points, numpy.where(turned[:, None], faces[:, ::-1], faces)


def _unwelded(points, faces):
    return points[faces].reshape(-1, 3), numpy.arange(faces.size).reshape(-1, 3)


def _dropped(points, faces):
    return points, faces[_lot().random(len(faces)) >= 0.4]


#: Name to maker, which is given the folder of the meshes; it may raise NoSurface.
MADE = {
    "moebius-strip": lambda folder: moebius_strip(),
    "klein-bottle": lambda folder: klein_bottle(),
    "t-junctions": lambda folder: t_junctions(),
    "duplicated-triangles": lambda folder: duplicated_triangles(),
    "one-triangle": lambda folder: one_triangle(),
    "random-soup": lambda folder: random_soup(),
    "stack-of-sheets": lambda folder: stack_of_sheets(),
    "grass": lambda folder: grass(),
    "elephant-reversed": _elephant(_reversed),
    "elephant-randomly-flipped": _elephant(_randomly_flipped),
    "elephant-unwelded": _elephant(_unwelded),
    "elephant-dropped": _elephant(_dropped),
}

#: Those of MADE that take long to read and draw.
LARGE = {name for name in MADE if name.startswith("elephant-")}
