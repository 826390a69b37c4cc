"""What `vtkshadows bench` found, as the plots and tables of Docs/Trade.md need it (see trade_page.py)."""

import json

# More than that of the receiver pixels, in percent, is gross error: one pixel in 100 000. A single one is none.
MOST_GROSS = 1e-3

# Percent of the pixels that may be wrong without a budget, where things are so thin that no pixel is far from an edge.
MOST_MISMATCH = 2.0
# Of a soft light, in the mean over all pixels and over those of the penumbra: what auto keeps to without a budget.
MOST_SOFT_DIFFERENCE, MOST_PENUMBRA_DIFFERENCE = 0.01, 0.04

PEER = "vtk-shadow-map"
KINDS = ("static", "moving")


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
        self.machine, self.plan, self.fits = data["machine"], data["plan"], data["fits"]
        self.failures = [row["key"] for row in data["rows"] if row["failure"]]
        rows = [row for row in data["rows"] if not row["failure"]]
        self.sweeps = [row for row in rows if row["axis"]]
        self.rows = [row for row in rows if not row["axis"] and row["errors"]]
        names = [scene["name"] for scene in data["scenes"]]
        self.scenes = [name for name in names if any(row["scene"] == name for row in self.rows)]

    def of(self, scene, soft=False):
        return [row for row in self.rows if row["scene"] == scene and row["soft"] == soft]


def worst(row, measure):
    """Of a row's lights the one that is most wrong."""
    return max(error[measure] for error in row["errors"])


def is_choice(row):
    """Whether it is a fixed setting of ours: neither what is chosen, nor none, nor VTK's own pass."""
    return row["technique"] not in ("auto", "none", PEER)


def is_gross(row):
    return any(error["gross_false_pixels"] + error["gross_missed_pixels"] > max(1, 0.01 * MOST_GROSS * error["receiver_pixels"])
               for error in row["errors"])  # fmt: skip


def is_right(row, most_mismatch=None):
    """Without gross error, and at most so much mismatch, in percent; soft, within what is hard to see beside the truth."""
    if is_gross(row):
        return False
    if row["soft"]:
        return (worst(row, "mean_absolute_difference") <= MOST_SOFT_DIFFERENCE
                and worst(row, "mean_penumbra_difference") <= MOST_PENUMBRA_DIFFERENCE)  # fmt: skip
    return worst(row, "mismatch_percent") <= (MOST_MISMATCH if most_mismatch is None else most_mismatch)


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
