"""What `vtkshadows bench` found, as the plots and tables of Docs/Trade.md need it (see trade_page.py)."""

import json

from error_limits import ErrorLimits

PEER = "vtk-shadow-map"
KINDS = ("static", "moving")

# Techniques that are looked up at every fragment: those by masks shade what is nearest in a pixel, and not translucent things.
AT_FRAGMENTS = ("depth-map", "object-id", "shadow-texture")


class Report:
    """Rows of bench.json; those of runs that failed are left out, and counted."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            try:
                data = json.load(file)
            except ValueError as error:
                raise ValueError(f"{path}: is no JSON ({error}); give a bench.json of vtkshadows bench") from None
        for key in ("machine", "plan", "scenes", "rows", "fits"):
            if key not in data:
                raise ValueError(f'{path}: has no "{key}"; give a bench.json of vtkshadows bench')
        try:
            self.limits = ErrorLimits.of_json(data.get("limits", {}))
        except KeyError as error:
            raise ValueError(f'{path}: has no {error} among "limits": an older vtkshadows wrote it; vtkshadows bench --resume '
                             "with the same options writes it anew, and measures nothing again") from None  # fmt: skip
        self.machine, self.plan, self.fits = data["machine"], data["plan"], data["fits"]
        self.failures = [row["key"] for row in data["rows"] if row["failure"]]
        rows = [row for row in data["rows"] if not row["failure"]]
        self.sweeps = [row for row in rows if row["axis"]]
        self.rows = [row for row in rows if not row["axis"] and row["errors"]]
        self.translucent = {scene["name"] for scene in data["scenes"] if scene.get("translucents")}
        names = [scene["name"] for scene in data["scenes"]]
        self.scenes = [name for name in names if any(row["scene"] == name for row in self.rows)]

    def of(self, scene, soft=False):
        return [row for row in self.rows if row["scene"] == scene and row["soft"] == soft]

    def choices(self, scene, soft=False):
        """Fixed settings of ours that shade all that the scene has: neither what is chosen, nor none, nor VTK's own pass."""
        rows = [row for row in self.of(scene, soft) if row["technique"] not in ("auto", "none", PEER)]
        return [row for row in rows if scene not in self.translucent or shades_translucents(row)]

    def is_gross(self, row):
        return any(self.limits.is_gross(error) for error in row["errors"])

    def is_right(self, row, most_mismatch=None):
        return all(self.limits.is_right(error, row["soft"], most_mismatch) for error in row["errors"])


def worst(row, measure):
    """Of a row's lights the one that is most wrong."""
    return max(error[measure] for error in row["errors"])


def shades_translucents(row):
    return row["technique"] in AT_FRAGMENTS or row["setting"].split("/")[-1].startswith("textures-")


def cheapest(rows, kind):
    """The row whose frame is shortest, over the frame without shadows; None of none."""
    return min(rows, key=lambda row: row["ratio_" + kind], default=None)


def pareto_front(points):
    """Of (cost, error): those than which none is both cheaper and less wrong."""
    front = []
    for point in sorted(points):
        if not front or point[1] < front[-1][1]:
            front.append(point)
    return front
