"""The first examples run, write the same picture, and it has a shadow."""
import pathlib
import re
import subprocess
import sys
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

PYTHON_EXAMPLE, CXX_EXAMPLE, FOLDER = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])


def read_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    print(done.stdout + done.stderr)
    return done


class TestExamples(unittest.TestCase):
    def test_both(self):
        pictures = [FOLDER / "first_shadow.png", FOLDER / "FirstShadow.png"]
        commands = [[sys.executable, PYTHON_EXAMPLE], [CXX_EXAMPLE]]
        for command, picture in zip(commands, pictures):
            picture.unlink(missing_ok=True)
            done = run(*command, str(picture))
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            if command[0] == sys.executable:
                share = float(re.fullmatch(r"shadow: ([\d.]+) % of the picture\n", done.stdout)[1])
                print(f"share of shadow: got {share} %, expected between 1 and 20 %")
                self.assertTrue(1 < share < 20)
        python, cxx = map(read_png, pictures)
        different = int((python != cxx).any(axis=2).sum())
        print(f"pixels that differ: got {different}, expected 0, tolerance 0")
        self.assertEqual(different, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
