"""Faults that mypy finds; never run."""

import acmap

acmap.read_cloud(3)  # wrong
acmap.read_map("map").planes[0].aera  # wrong
acmap.triangulate([[0.0, 0.0, 1.0]])  # wrong
acmap.CompactMapping(True)  # wrong
acmap.read_map("map").area = 3  # wrong
acmap.read_mesh("mesh.ply").wall_depth.shape  # wrong
