"""Time of object-ID maps, beside the depth map's: the figures in Docs/Techniques.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a python3 Benchmark/object_costs.py

The scene and the way of measuring are those of planar_costs.py.
"""
from planar_costs import main

WAYS = {"depth-map": ("depth-map", {})}
for bits in (8, 16, 24, 32):
    WAYS[f"object-id, {bits} bits"] = ("object-id", {"object_depth_bits": bits})
WAYS["object-id, 3 x 3 taps"] = ("object-id", {"object_taps": 3})
WAYS["object-id, by piece"] = ("object-id", {"object_type": "piece"})
WAYS["object-id, IDs alone"] = ("object-id", {"object_depth": False})
WAYS["object-id, IDs alone, by piece"] = ("object-id", {"object_depth": False, "object_type": "piece"})


if __name__ == "__main__":
    main(__doc__.splitlines()[0], WAYS)
