"""What the tests of the command share: running it, checking, reading PNGs, writing meshes.

A check prints what it got, what it expected and the tolerance; a script ends with finish(), whose
exit status is 1 if a check failed.
"""

import atexit
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

failures = 0


def check(what, got, expected, tolerance=0):
    """Within the tolerance if the values are numbers, else equal."""
    global failures
    if isinstance(got, (int, float)) and not isinstance(got, bool):
        right = abs(got - expected) <= tolerance
    else:
        right = got == expected
    failures += not right
    verdict = "ok   " if right else "WRONG"
    print(f"{verdict} {what}: got {got}, expected {expected}, tolerance {tolerance}")
    return right


def enter_empty_folder():
    """Work in a folder of the test's own, which goes with it."""
    folder = tempfile.mkdtemp(prefix="vtkshadows-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    os.chdir(folder)


def finish():
    print(f"{failures} check(s) failed")
    sys.exit(1 if failures else 0)


def command(*arguments, environment=None):
    """Run the vtkshadows that the test was given; status, stdout and stderr."""
    run = subprocess.run(
        [sys.argv[1], *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
        check=False,
    )
    return run.returncode, run.stdout, run.stderr


def succeed(*arguments):
    """Run the command, which must succeed; its stdout."""
    status, out, err = command(*arguments)
    if not check("status of " + " ".join(map(str, arguments)), status, 0):
        print(err)
    return out


class Image:
    """The pixels of an 8-bit PNG, row 0 at the top: rows[y][x] is a tuple of channels."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG"
        packed = b""
        at = 8
        while at < len(data):
            length, kind = struct.unpack(">I4s", data[at : at + 8])
            body = data[at + 8 : at + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, self.depth, color = struct.unpack(">IIBB", body[:10])
                self.channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
            elif kind == b"IDAT":
                packed += body
            at += length + 12
        self.rows = self._unfilter(zlib.decompress(packed))

    def _unfilter(self, raw):
        # The five filters of the PNG specification, section 9.
        step, stride = self.channels, self.channels * self.width
        previous, rows = bytearray(stride), []
        for y in range(self.height):
            start = y * (stride + 1)
            kind, line = raw[start], bytearray(raw[start + 1 : start + 1 + stride])
            for i in range(stride):
                left = line[i - step] if i >= step else 0
                up = previous[i]
                corner = previous[i - step] if i >= step else 0
                if kind == 1:
                    line[i] = (line[i] + left) & 255
                elif kind == 2:
                    line[i] = (line[i] + up) & 255
                elif kind == 3:
                    line[i] = (line[i] + (left + up) // 2) & 255
                elif kind == 4:
                    line[i] = (line[i] + self._paeth(left, up, corner)) & 255
            rows.append([tuple(line[i : i + step]) for i in range(0, stride, step)])
            previous = line
        return rows

    @staticmethod
    def _paeth(left, up, corner):
        estimate = left + up - corner
        return min((left, up, corner), key=lambda value: abs(estimate - value))

    def count(self, value):
        return sum(row.count(value) for row in self.rows)


def write_off(path, points, faces):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        for point in points:
            file.write("{} {} {}\n".format(*point))
        for face in faces:
            file.write(" ".join(map(str, [len(face), *face])) + "\n")


def write_plate(path, height=1.0, half=0.5):
    """A square above the floor, parallel to it."""
    points = [(-half, -half), (half, -half), (half, half), (-half, half)]
    write_off(path, [(x, y, height) for x, y in points], [(0, 1, 2, 3)])


def write_tetrahedron(path):
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    write_off(path, points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])


def tree(folder):
    """Every file and folder below `folder`, to see that nothing was left behind."""
    return sorted(
        os.path.relpath(os.path.join(root, name), folder)
        for root, folders, files in os.walk(folder)
        for name in folders + files
    )
