"""Saves ordinary.png: the scene in ParaView's own render view, for TestShadowView.py to compare with.

A process of its own: ParaView 6.1 warns of leaked textures wherever two views are closed.
"""
import pathlib
import sys

from scene import add_light, make_view, screenshot

VIEW = make_view("RenderView")
LIGHT = add_light(VIEW)
screenshot(VIEW, pathlib.Path(sys.argv[1]) / "ordinary.png")
