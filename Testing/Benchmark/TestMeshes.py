"""Meshes of the benchmarks: dialects of OFF, what is refused and why, and what the made ones are."""
import pathlib
import sys
import tempfile
import unittest

import numpy

sys.path.insert(0, sys.argv.pop())
import meshes  # noqa: E402  (its folder is an argument)

SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
FACES = [[0, 1, 2], [0, 2, 3]]


def edges_of(mesh):
    """How many triangles share each edge."""
    faces = meshes.arrays_of(mesh)[1]
    edges = numpy.sort(numpy.concatenate((faces[:, :2], faces[:, 1:], faces[:, ::2])), axis=1)
    return numpy.unique(edges, axis=0, return_counts=True)[1]


class TestMeshes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def written(self, text, name="mesh.off"):
        path = self.folder / name
        path.write_bytes(text.encode())
        return path

    def test_dialects(self):
        points, faces = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n", "3 0 1 2\n3 0 2 3\n"
        airy = points.replace("\n", " # d\n\n")
        for name, text in {
            "plain": "OFF\n4 2 0\n" + points + faces,
            "counts on the keyword's line": "OFF 4 2 0\n" + points + faces,
            "no keyword": "4 2 0\n" + points + faces,
            "two counts": "OFF\n4 2\n" + points + faces,
            "comments and blank lines": "# a\n\nOFF # b\n\n4 2 0\n#c\n" + airy + faces,
            "carriage returns": ("OFF\n4 2 0\n" + points + faces).replace("\n", "\r\n"),
            "vertex colours": "COFF\n4 2 0\n" + points.replace("\n", " 9 8 7 255\n") + faces,
            "vertex normals": "NOFF\n4 2 0\n" + points.replace("\n", " 0 0 1\n") + faces,
            "texture coordinates": "STOFF\n4 2 0\n" + points.replace("\n", " .5 .5\n") + faces,
            "face colours": "OFF\n4 2 0\n" + points + faces.replace("\n", "  0.9 0 0 #red\n"),
        }.items():
            with self.subTest(name):
                read = meshes.arrays_of(meshes.read_off(self.written(text)))
                numpy.testing.assert_array_equal(read[0], SQUARE)
                numpy.testing.assert_array_equal(read[1], FACES)

    def test_faces_are_kept(self):
        points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 9 nan\n"
        faces = "4 0 1 2 3\n3 0 0 1\n3 0 1 2\n3 0 1 4\n2 0 1\n"
        mesh = meshes.read_mesh(self.written("OFF\n5 5 0\n" + points + faces))
        # All but the one of two vertices; the quad counts as two triangles.
        self.assertEqual(mesh.GetNumberOfPolys(), 4)
        self.assertEqual(meshes.triangle_count(mesh), 5)
        numpy.testing.assert_array_equal(meshes.surface_points(mesh), SQUARE)

    def test_refused(self):
        for pattern, text in {
            "the file ends before the counts": "",
            "the file ends before vertex 1": "OFF\n2 0 0\n0 0 0\n",
            "vertex 0 has 2 of 3 numbers": "OFF\n1 0 0\n0 0\n",
            "face 0 names a vertex that is not one of 3": "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
            "face 0 has 2 of 3 numbers": "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n",
            "the counts: a b are no numbers": "a b\n",
            "4OFF has not three coordinates": "4OFF\n1 1 0\n",
            "BINARY is not read": "OFF BINARY\n",
        }.items():
            with self.subTest(pattern), self.assertRaisesRegex(ValueError, pattern):
                meshes.read_mesh(self.written(text))
        with self.assertRaisesRegex(ValueError, "nothing in it could be read"):
            meshes.read_mesh(self.written("nonsense", "mesh.ply"))

    def test_no_surface(self):
        with self.assertRaisesRegex(meshes.NoSurface, "no faces, only 1 points"):
            meshes.read_mesh(self.written("OFF\n1 0 0\n0 0 0\n"))
        with self.assertRaisesRegex(meshes.NoSurface, ".xyz is no surface format"):
            meshes.read_mesh(self.written("0 0 0\n", "points.xyz"))

    def test_made(self):
        self.assertEqual(set(edges_of(meshes.klein_bottle())), {2})
        border = edges_of(meshes.moebius_strip()) == 1
        self.assertEqual(border.sum(), 2 * 90)  # one border, twice around
        self.assertEqual(meshes.triangle_count(meshes.random_soup()), 10_000)
        self.assertEqual(meshes.triangle_count(meshes.stack_of_sheets()), 2 * 300)
        with self.assertRaisesRegex(meshes.NoSurface, "refined_elephant.off"):
            meshes.MADE["elephant-dropped"](self.folder)


if __name__ == "__main__":
    unittest.main()
