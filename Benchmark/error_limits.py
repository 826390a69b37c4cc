"""Which error passes for none: what "auto" keeps to without a budget, by limits that C++ tells (Core/TechniqueChoice.h)."""

from dataclasses import dataclass, fields


@dataclass(frozen=True)
class ErrorLimits:
    """Percentages are of the receiver pixels, or of the penumbra's; soft ones are of mean differences."""

    gross_percent: float
    gross_pixels: int
    mismatch_percent: float
    soft_difference_percent: float
    penumbra_difference_percent: float

    @classmethod
    def of_json(cls, limits):
        """Of "limits" in bench.json; KeyError for one that is missing."""
        return cls(**{each.name: limits[each.name] for each in fields(cls)})

    @classmethod
    def of_library(cls):
        """Of the vtkshadows that Python imports."""
        from vtkshadows import vtkShadowErrorMeasure

        names = {each.name: "".join(part.title() for part in each.name.split("_")) for each in fields(cls)}
        return cls(**{name: getattr(vtkShadowErrorMeasure, "GetMost" + method)() for name, method in names.items()})

    def is_gross(self, error):
        """Of one light's error, every pixel measured: a mapping with the names that bench.json has."""
        pixels = error["gross_false_pixels"] + error["gross_missed_pixels"]
        return pixels > self.gross_pixels and error["gross_percent"] > self.gross_percent

    def is_right(self, error, soft=False, most_mismatch=None):
        """Without gross error, and, soft, hard to tell from the truth; else of at most so much mismatch, in percent."""
        if self.is_gross(error):
            return False
        if soft:
            return (100 * error["mean_absolute_difference"] <= self.soft_difference_percent
                    and 100 * error["mean_penumbra_difference"] <= self.penumbra_difference_percent)  # fmt: skip
        return error["mismatch_percent"] <= (self.mismatch_percent if most_mismatch is None else most_mismatch)
