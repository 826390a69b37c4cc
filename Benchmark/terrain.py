"""A terrain 10 km wide with hills, ridges, houses, trees and stones, all by lot, for cascades to be held against.

World units are metres, z is up. The eye stands near the middle, where things stand closer together.
"""
import math
import random

import numpy
from ground_floor import actor_of, directional_light
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper, vtkRenderer

WIDTH = 10000.0


def polydata(points, triangles):
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(numpy.asarray(points, dtype=numpy.float32), deep=True))
    data.SetPoints(vtk_points)
    cells = vtkCellArray()
    flat = numpy.asarray(triangles, dtype=numpy.int64).ravel()
    offsets = numpy.arange(0, len(flat) + 1, 3, dtype=numpy.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(flat, deep=True))
    data.SetPolys(cells)
    return data


def mesh(points, triangles, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(polydata(points, triangles))
    return actor_of(mapper, color)


class Heights:
    """Hills, and ridges where two hills' heights change sign, as a sum of waves by lot."""

    def __init__(self, seed):
        lot = numpy.random.default_rng(seed)
        count = 40
        length = 10 ** lot.uniform(2.0, 3.6, count)
        turn = lot.uniform(0, 2 * math.pi, count)
        self.wave = 2 * math.pi / length * numpy.array([numpy.cos(turn), numpy.sin(turn)])
        self.phase = lot.uniform(0, 2 * math.pi, count)
        self.height = 0.008 * length * lot.uniform(0.4, 1.0, count)
        self.is_ridge = lot.uniform(0, 1, count) < 0.3

    def __call__(self, x, y):
        height = numpy.zeros(numpy.shape(x))
        for kx, ky, phase, top, ridge in zip(*self.wave, self.phase, self.height, self.is_ridge):
            wave = numpy.sin(kx * x + ky * y + phase)
            height += top * (1 - 2 * numpy.abs(wave) if ridge else wave)
        return height


class Ground:
    """The triangles of the terrain, and the height of what stands on them."""

    def __init__(self, seed, cells):
        self.cells = cells
        line = numpy.linspace(-WIDTH / 2, WIDTH / 2, cells + 1)
        self.x, self.y = numpy.meshgrid(line, line)
        self.z = Heights(seed)(self.x, self.y)

    def actor(self):
        n = self.cells + 1
        corner = (numpy.arange(self.cells)[:, None] * n + numpy.arange(self.cells)).ravel()
        triangles = numpy.concatenate(
            [
                numpy.stack([corner, corner + 1, corner + n + 1], 1),
                numpy.stack([corner, corner + n + 1, corner + n], 1),
            ]
        )
        points = numpy.stack([self.x.ravel(), self.y.ravel(), self.z.ravel()], 1)
        return mesh(points, triangles, (0.55, 0.62, 0.42))

    def height(self, x, y):
        step = WIDTH / self.cells
        u, v = (x + WIDTH / 2) / step, (y + WIDTH / 2) / step
        i, j = min(int(u), self.cells - 1), min(int(v), self.cells - 1)
        u, v = u - i, v - j
        z = self.z
        if u >= v:  # the triangle with the corner at the right
            return z[j, i] + u * (z[j, i + 1] - z[j, i]) + v * (z[j + 1, i + 1] - z[j, i + 1])
        return z[j, i] + v * (z[j + 1, i] - z[j, i]) + u * (z[j + 1, i + 1] - z[j + 1, i])


BOX = [(x, y, z) for z in (0, 1) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
BOX_FACES = [
    (0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
    (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5),
]  # fmt: skip


def cone(sides=8):
    rim = [(0.5 * math.cos(a), 0.5 * math.sin(a), 0.15) for a in numpy.arange(sides) * 2 * math.pi / sides]
    points = rim + [(0, 0, 1), (0, 0, 0.15)]
    faces = [(i, (i + 1) % sides, sides) for i in range(sides)]
    faces += [((i + 1) % sides, i, sides + 1) for i in range(sides)]
    return points, faces


def copies(ground, lot, count, shape, size, color, nearest, farthest, eye):
    """`count` of them in one actor, at distances from the eye by lot: the nearer, the denser."""
    points, faces = numpy.array(shape[0], dtype=float), numpy.array(shape[1])
    all_points, all_faces = [], []
    while len(all_points) < count:
        r = lot.uniform(nearest, farthest)
        a = lot.uniform(0, 2 * math.pi)
        x, y = eye[0] + r * math.cos(a), eye[1] + r * math.sin(a)
        if max(abs(x), abs(y)) > 0.49 * WIDTH:
            continue
        turn, scale = lot.uniform(0, math.pi), [s * lot.uniform(0.6, 1.4) for s in size]
        p = points * scale
        c, s = math.cos(turn), math.sin(turn)
        p = numpy.stack([c * p[:, 0] - s * p[:, 1] + x, s * p[:, 0] + c * p[:, 1] + y, p[:, 2]], 1)
        p[:, 2] += ground.height(x, y) - 0.05 * scale[2]
        all_faces.append(faces + len(all_points) * len(points))
        all_points.append(p)
    return mesh(numpy.concatenate(all_points), numpy.concatenate(all_faces), color)


def terrain(seed=1, elevation=15.0, azimuth=35.0, cells=320, things=1.0):
    """A renderer with the scene and a sun `elevation` degrees high; and the place of the eye, 2 m above ground."""
    lot = random.Random(seed)
    ground = Ground(seed, cells)
    eye = (lot.uniform(-500, 500), lot.uniform(-500, 500))
    renderer = vtkRenderer()
    renderer.SetBackground(0.7, 0.8, 0.95)
    renderer.AddActor(ground.actor())
    kinds = [
        (1200, (BOX, BOX_FACES), (9, 12, 6), (0.8, 0.6, 0.5), 30, 4000),
        (3000, cone(), (5, 5, 11), (0.3, 0.5, 0.3), 25, 4500),
        (400, (BOX, BOX_FACES), (0.5, 0.5, 0.6), (0.6, 0.6, 0.6), 4, 150),
    ]
    for count, shape, size, color, nearest, farthest in kinds:
        count = int(count * things)
        renderer.AddActor(copies(ground, lot, count, shape, size, color, nearest, farthest, eye))
    e, a = math.radians(elevation), math.radians(azimuth)
    renderer.AddLight(
        directional_light((-math.cos(e) * math.cos(a), -math.cos(e) * math.sin(a), -math.sin(e)))
    )
    return renderer, (*eye, ground.height(*eye) + 2.0)


def look(renderer, eye, azimuth, tilt=-3.0, near=0.5):
    """Turn the camera, at `eye`, to an azimuth in degrees; its clipping range is the same for all."""
    camera = renderer.GetActiveCamera()
    a, t = math.radians(azimuth), math.radians(tilt)
    camera.SetPosition(eye)
    camera.SetFocalPoint(
        eye[0] + math.cos(t) * math.cos(a), eye[1] + math.cos(t) * math.sin(a), eye[2] + math.sin(t)
    )
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(30)
    camera.SetClippingRange(near, 2 * WIDTH)
