"""Time of shadow textures, beside the depth map's and planar textures': the figures in Docs/Techniques.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a python3 Benchmark/shadow_texture_costs.py

The scene, the views and the way of measuring are those of planar_costs.py.
"""
from planar_costs import main

WAYS = {
    "shadow-texture": ("shadow-texture", {}),
    "shadow-texture, one each": ("shadow-texture", {"texture_per_caster": True}),
    "shadow-texture, soft": ("shadow-texture", {"radius": 0.1}),
    "depth-map": ("depth-map", {}),
    "planar, textures": ("planar", {"plane_textures": True}),
}

if __name__ == "__main__":
    main(__doc__.splitlines()[0], WAYS)
