"""The rule of which error passes for none: in Python as in Core, by the same limits."""
import json
import subprocess
import sys
import unittest

sys.path.insert(0, sys.argv.pop())
CASES = json.loads(subprocess.run([sys.argv.pop()], check=True, capture_output=True, text=True).stdout)

from auto_choice import keeps  # noqa: E402  (its folder is an argument)
from error_limits import ErrorLimits  # noqa: E402


class TestErrorLimits(unittest.TestCase):
    def test_limits(self):
        """The same from Core, from JSON and from the library that Python imports."""
        core = CASES["limits"]
        self.assertEqual(vars(ErrorLimits.of_json(core)), core)
        self.assertEqual(vars(ErrorLimits.of_library()), core)
        with self.assertRaisesRegex(KeyError, "mismatch_percent"):
            ErrorLimits.of_json({name: value for name, value in core.items() if name != "mismatch_percent"})

    def test_rule(self):
        limits = ErrorLimits.of_json(CASES["limits"])
        unlike = [case for case in CASES["cases"] if limits.is_right(case, case["soft"]) != case["right"]]
        for soft in (False, True):
            for right in (False, True):
                count = sum((case["soft"], case["right"]) == (soft, right) for case in CASES["cases"])
                print(f"soft {soft}, right {right}: got {count} cases, expected 100 or more")
                self.assertGreaterEqual(count, 100)
        print(f"cases that Python tells otherwise than Core: got {len(unlike)}, expected 0: {unlike[:3]}")
        self.assertEqual(unlike, [])

    def test_gross(self):
        """A single pixel is none, however few are seen."""
        limits = ErrorLimits.of_json(CASES["limits"])
        for false, missed, percent, expected in ((1, 0, 5, False), (0, 2, 5, True), (1, 1, 0.0009, False), (3, 4, 0.0011, True)):
            error = {"gross_false_pixels": false, "gross_missed_pixels": missed, "gross_percent": percent}
            self.assertEqual(limits.is_gross(error), expected, error)

    def test_auto_choice(self):
        """Without a budget by the same rule; else by mismatch alone, of every light."""
        hard = [case for case in CASES["cases"] if not case["soft"]]
        self.assertEqual([case for case in hard if keeps([case], 0) != case["right"]], [])
        wrong, right = (next(case for case in hard if case["right"] == each) for each in (False, True))
        self.assertFalse(keeps([right, wrong], 0))
        low, high = ({"mismatch_percent": each} for each in (0.1, 0.2))
        self.assertTrue(keeps([low], 0.1))
        self.assertFalse(keeps([low, high], 0.1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
