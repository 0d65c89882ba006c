#!/usr/bin/env python3
"""Writes the points of a binary PCD again and again, each copy moved, as one cloud of any size.

usage: repeat_cloud.py IN.pcd OUT.pcd|OUT.las COLUMNS ROWS STEP_X STEP_Z

The copies stand side by side along x and z, STEP_X and STEP_Z metres apart; of their fields, x, y, z
and, if it follows them, rgb are written. Points beside each other differ by what floats resolve at their place, and the memory
needed is that of one copy. A LAS (1.2, steps of 1 mm) has the heights -y in z, and lies in a national grid.
"""

import struct
import sys

import numpy

GRID = (500000, 4000000, 100)  # east, north and height of the origin, metres


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


def pcd_header(points, has_color):
    fields = ["x", "y", "z"] + ["rgb"] * has_color
    return f"""VERSION 0.7
FIELDS {" ".join(fields)}
SIZE {" ".join("4" for _ in fields)}
TYPE {" ".join("F" for _ in fields)}
COUNT {" ".join("1" for _ in fields)}
WIDTH {points}
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS {points}
DATA binary
""".encode("ascii")


def las_header(points, has_color):
    header = struct.pack("<4s4xIHH8xBB", b"LASF", 0, 0, 0, 1, 2)
    header += struct.pack("<32s32sHHHII", b"", b"repeat_cloud.py", 1, 2026, 227, 227, 0)
    header += struct.pack("<BHI5I", 2 if has_color else 0, 26 if has_color else 20, points, *[0] * 5)
    return header + struct.pack("<12d", *[1e-3] * 3, *GRID, *[0] * 6)


def las_records(cloud):
    """The points as records of format 0, or 2 with colours."""
    has_color = cloud.shape[1] > 3
    fields = [("place", "<i4", 3), ("intensity", "<u2"), ("rest", "u1", 6)]
    records = numpy.zeros(len(cloud), fields + [("color", "<u2", 3)] * has_color)
    heights = numpy.stack([cloud[:, 0], cloud[:, 2], -cloud[:, 1]], axis=1)
    records["place"] = numpy.rint(heights.astype(numpy.float64) * 1000)
    if has_color:
        packed = numpy.ascontiguousarray(cloud[:, 3]).view(numpy.uint32)
        for channel in range(3):
            records["color"][:, channel] = (packed >> (16 - 8 * channel)) & 255
    return records


def main():
    if len(sys.argv) != 7:
        sys.exit(__doc__)
    source, target = sys.argv[1:3]
    columns, rows = map(int, sys.argv[3:5])
    step_x, step_z = map(float, sys.argv[5:7])
    with open(source, "rb") as file:
        cloud = points_of(file)
    is_las = target.endswith(".las")
    points = len(cloud) * columns * rows
    with open(target, "wb") as file:
        file.write((las_header if is_las else pcd_header)(points, cloud.shape[1] > 3))
        moved = cloud.copy()
        for column in range(columns):
            for row in range(rows):
                moved[:, 0] = cloud[:, 0] + numpy.float32(column * step_x)
                moved[:, 2] = cloud[:, 2] + numpy.float32(row * step_z)
                (las_records(moved) if is_las else moved).tofile(file)


if __name__ == "__main__":
    main()
