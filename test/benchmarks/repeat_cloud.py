#!/usr/bin/env python3
"""Writes the points of a binary PCD again and again, each copy moved, as one cloud of any size.

usage: repeat_cloud.py IN.pcd OUT.pcd COLUMNS ROWS STEP_X STEP_Z

The copies stand side by side along x and z, STEP_X and STEP_Z metres apart; of their fields, x, y, z
and, if it follows them, rgb are written. Points beside each other differ by what floats resolve at their place, and the memory
needed is that of one copy.
"""

import sys

import numpy


def points_of(file):
    """The coordinates of a PCD whose fields all have 4 bytes."""
    values = {}
    while "DATA" not in values:
        line = file.readline().decode("ascii")
        if not line:
            sys.exit("not a PCD")
        name, *values_of_line = line.split()
        values[name] = values_of_line
    if values["FIELDS"][:3] != ["x", "y", "z"] or set(values["SIZE"]) != {"4"}:
        sys.exit("the fields have to be x, y, z, and others of 4 bytes")
    if values["DATA"] != ["binary"]:
        sys.exit("the PCD has to be binary")
    rows = numpy.fromfile(file, dtype=numpy.float32)
    kept = 4 if values["FIELDS"][3:4] == ["rgb"] else 3
    return rows.reshape(-1, len(values["FIELDS"]))[:, :kept].copy()


def main():
    if len(sys.argv) != 7:
        sys.exit(__doc__)
    source, target = sys.argv[1:3]
    columns, rows = map(int, sys.argv[3:5])
    step_x, step_z = map(float, sys.argv[5:7])
    with open(source, "rb") as file:
        cloud = points_of(file)
    points = len(cloud) * columns * rows
    with open(target, "wb") as file:
        fields = ["x", "y", "z", "rgb"][: cloud.shape[1]]
        file.write(f"""VERSION 0.7
FIELDS {" ".join(fields)}
SIZE {" ".join("4" for _ in fields)}
TYPE {" ".join("F" for _ in fields)}
COUNT {" ".join("1" for _ in fields)}
WIDTH {points}
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS {points}
DATA binary
""".encode("ascii"))
        moved = cloud.copy()
        for column in range(columns):
            for row in range(rows):
                moved[:, 0] = cloud[:, 0] + numpy.float32(column * step_x)
                moved[:, 2] = cloud[:, 2] + numpy.float32(row * step_z)
                moved.tofile(file)


main()
