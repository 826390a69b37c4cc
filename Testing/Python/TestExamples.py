"""The examples run: the first ones write the same picture, and it has a shadow; the volume is a file, and
the outline is; the picture that explains differs from the plain one; the figure on a page is transparent
around it."""
import pathlib
import re
import subprocess
import sys
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

(
    PYTHON_EXAMPLE,
    CXX_EXAMPLE,
    VOLUME_EXAMPLE,
    STENCIL_EXAMPLE,
    PAGE_EXAMPLE,
    AREA_EXAMPLE,
    PLANAR_EXAMPLE,
    OBJECT_EXAMPLE,
    TEXTURE_EXAMPLE,
    CASCADES_EXAMPLE,
    SOFT_EXAMPLE,
    IMAGE_EXAMPLE,
    TRANSLUCENT_EXAMPLE,
    CHOICE_EXAMPLE,
    FILTERS_EXAMPLE,
) = sys.argv[1:16]
FOLDER = pathlib.Path(sys.argv[16])


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
    def said_by(self, example, files, *arguments):
        """What an example prints that writes the files."""
        for file in files:
            file.unlink(missing_ok=True)
        done = run(sys.executable, example, *map(str, arguments))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

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

    def test_volume(self):
        file = FOLDER / "shadow_volume.vtp"
        said = self.said_by(VOLUME_EXAMPLE, [file], file)
        self.assertRegex(said, r"^silhouette: \d+ edges, length [\d.]+\nvolume: \d+ triangles")
        count = int(re.search(r"volume: (\d+) triangles", said)[1])
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(file))
        reader.Update()
        print(f"triangles in the file: got {reader.GetOutput().GetNumberOfCells()}, expected {count}")
        self.assertEqual(reader.GetOutput().GetNumberOfCells(), count)

    def test_area(self):
        file = FOLDER / "shadow_outline.vtp"
        said = self.said_by(AREA_EXAMPLE, [file], file)
        areas = [float(area) for area in re.findall(r"shadow ([\d.]+)", said)]
        print(f"areas: got {areas}, expected 6 that grow as the sun sinks")
        self.assertEqual(len(areas), 6)
        self.assertEqual(areas, sorted(areas))
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(file))
        reader.Update()
        loops = reader.GetOutput().GetCellData().GetArray("LoopArea")
        self.assertAlmostEqual(vtk_to_numpy(loops).sum(), areas[-1], delta=1e-3)

    def test_stencil_volumes(self):
        files = [FOLDER / "stencil_volumes.png", FOLDER / "stencil_volumes-explained.png"]
        said = self.said_by(STENCIL_EXAMPLE, files, *files)
        layers = int(re.fullmatch(r"most layers over a pixel: (\d+)\n", said)[1])
        print(f"layers: got {layers}, expected 2 or more: the strip crosses over itself")
        self.assertGreaterEqual(layers, 2)
        plain, explained = map(read_png, files)
        different = int((plain != explained).any(axis=2).sum())
        print(f"pixels that differ: got {different}, expected 1000 or more")
        self.assertGreaterEqual(different, 1000)

    def test_figure_on_a_page(self):
        file = FOLDER / "figure_on_a_page.png"
        self.assertEqual(self.said_by(PAGE_EXAMPLE, [file], file), "")
        alpha = read_png(file)[..., 3]
        shares = [100 * float(part.mean()) for part in (alpha == 0, alpha % 255 > 0, alpha == 255)]
        print(f"transparent, shadow, figure: got {shares} %, expected 50, 3 and 10 or more")
        self.assertTrue(shares[0] >= 50 and shares[1] >= 3 and shares[2] >= 10)

    def test_planar_shadows(self):
        files = [FOLDER / "planar_shadows.png", FOLDER / "planar_shadows_texture.png"]
        said = self.said_by(PLANAR_EXAMPLE, files, FOLDER)
        hard = float(re.search(r"hard: ([\d.]+) %", said)[1])
        soft = [float(mean) for mean in re.findall(r": ([\d.]+) from the truth", said)]
        print(f"errors: got {hard} % and {soft}, expected at most 0.05 % and three, the last at most 0.01")
        self.assertLessEqual(hard, 0.05)
        self.assertEqual(len(soft), 3)
        self.assertLessEqual(soft[-1], 0.01)
        picture, texture = map(read_png, files)
        self.assertEqual(picture.shape[:2], (480, 640))
        shares = [100 * float(part.mean()) for part in (texture == 0, texture % 255 > 0, texture == 255)]
        print(f"texture dark, between, lit: got {shares} %, expected 10 and more of each")
        self.assertTrue(min(shares) >= 10)

    def test_object_ids(self):
        files = [FOLDER / "object_ids.png", FOLDER / "object_ids-alone.png"]
        said = self.said_by(OBJECT_EXAMPLE, files, *files)
        rows = re.findall(r"(\w+), depths (\w+): +([\d.]+) % in shadow", said)
        shares = [float(share) for *_, share in rows]
        # IDs alone do not darken the sides that turn from the light: they are dark already.
        print(f"in shadow: got {shares} %, expected 5 and more, then four fifths of it, then nothing")
        self.assertEqual([row[:2] for row in rows], [("piece", "on"), ("piece", "off"), ("prop", "off")])
        self.assertGreater(shares[0], 5)
        self.assertGreater(shares[1], 0.8 * shares[0])
        self.assertEqual(shares[2], 0)
        deep, alone = map(read_png, files)
        different = int((deep != alone).any(axis=2).sum())
        print(f"pixels that differ: got {different}, expected 1000 or more")
        self.assertGreaterEqual(different, 1000)

    def test_shadow_texture(self):
        file = FOLDER / "shadow_texture.png"
        said = self.said_by(TEXTURE_EXAMPLE, [file], file)
        self.assertIn("Nothing shadows itself", said)
        hard = float(re.search(r"hard: ([\d.]+) %", said)[1])
        soft = float(re.search(r"soft: ([\d.]+) from", said)[1])
        print(f"errors: got {hard} % and {soft}, expected at most 0.05 % and 0.004")
        self.assertLessEqual(hard, 0.05)
        self.assertLessEqual(soft, 0.004)
        self.assertEqual(read_png(file).shape[:2], (480, 640))

    def test_cascades(self):
        files = [FOLDER / "cascades.png", FOLDER / "cascades_explained.png"]
        said = self.said_by(CASCADES_EXAMPLE, files, FOLDER)
        one, four = (float(share) for share in re.findall(r": ([\d.]+) %", said))
        print(f"wrong: got {one} and {four} %, expected at most a third of the first")
        self.assertLess(3 * four, one)
        plain, explained = map(read_png, files)
        different = int((plain != explained).any(axis=2).sum())
        print(f"pixels that differ: got {different}, expected 1000 or more")
        self.assertGreaterEqual(different, 1000)

    def test_soft_shadows(self):
        picture = FOLDER / "soft_shadows.png"
        said = self.said_by(SOFT_EXAMPLE, [picture], FOLDER)
        hard, sampled, soft = (float(mean) for mean in re.findall(r": ([\d.]+) from the truth", said))
        print(f"errors: got {hard}, {sampled} and {soft}, expected the second and third at most half of the first")
        self.assertLessEqual(max(sampled, soft), hard / 2)
        self.assertEqual(read_png(picture).shape[:2], (480, 640))

    def test_projected_texture(self):
        file = FOLDER / "projected_texture.png"
        said = self.said_by(IMAGE_EXAMPLE, [file], file)
        share = float(re.search(r"cone: ([\d.]+) %", said)[1])
        picture = read_png(file).astype(int)
        warm = int((picture[..., 0] > picture[..., 2] + 30).sum())
        print(f"in shadow: got {share} %, expected 1 to 20; pixels lit through panes: got {warm}, expected 5000 or more")
        self.assertTrue(1 < share < 20)
        self.assertGreaterEqual(warm, 5000)

    def test_translucent_casters(self):
        """One pane halves the light, two leave a quarter; there is no grain between."""
        file = FOLDER / "translucent_casters.png"
        said = self.said_by(TRANSLUCENT_EXAMPLE, [file], FOLDER)
        half, quarter = (float(re.search(rf"{share}: ([\d.]+) %", said)[1]) for share in ("0.5", "0.25"))
        print(f"half: got {half} %, expected 1 to 20; a quarter: got {quarter} %, expected 0.5 to 20")
        self.assertTrue(1 < half < 20 and 0.5 < quarter < 20)
        self.assertEqual(read_png(file).shape[:2], (480, 640))

    def test_choice(self):
        """Each budget is kept to, and the picture is by the fastest that the explanation names."""
        file = FOLDER / "choice.png"
        said = self.said_by(CHOICE_EXAMPLE, [file], FOLDER)
        errors = [float(share) for share in re.findall(r": ([\d.]+) % are wrong", said)]
        print(f"errors: got {errors}, expected at most 2, 0.005 and the second")
        self.assertEqual(len(errors), 3)
        self.assertTrue(errors[0] <= 2 and errors[1] <= 0.005 and errors[2] <= errors[1])
        sentences = [line for line in said.splitlines() if line.startswith("  ")]
        for sentence in sentences[:2]:
            taken = float(re.search(r"([\d.]+) ms a frame", sentence)[1])
            others = [float(time) for time in re.findall(r"takes ([\d.]+) ms", sentence)]
            print(f"it takes {taken} ms, others {others}: expected no more than the least and 6 % of it")
            self.assertLessEqual(taken, 1.06 * min(others, default=taken))
        self.assertIn("within the 10000 ms", sentences[2])
        self.assertEqual(read_png(file).shape[:2], (480, 640))

    def test_depth_map_filters(self):
        file = FOLDER / "depth_map_filters.png"
        said = self.said_by(FILTERS_EXAMPLE, [file], FOLDER)
        wrong = {name: float(share) for name, share in re.findall(r"(.+): ([\d.]+) % are wrong", said)}
        print(f"wrong: got {wrong}, expected a third of any other at most by exact, acne without a bias")
        self.assertEqual(len(wrong), 8)
        exact, acne = wrong.pop("exact"), wrong.pop("bias of the user's, none")
        self.assertLessEqual(3 * exact, min(wrong.values()))
        self.assertGreater(acne, 10 * max(wrong.values()))
        self.assertEqual(read_png(file).shape[:2], (480, 640))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
