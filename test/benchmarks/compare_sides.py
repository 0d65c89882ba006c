#!/usr/bin/env python3
"""Tells how much of the planes of a map without sensors faces the same way as with them.

usage: compare_sides.py MAP_WITH_SENSORS MAP_OF_LAS

MAP_OF_LAS is made of what repeat_cloud.py wrote, as one copy, of the cloud of the other map. Each of its
planes is compared with the nearest plane of the other map that has the same direction, reaches its middle
and is at most 6 cm away.
"""

import json
import pathlib
import sys

import numpy

from repeat_cloud import GRID


def planes_of(folder):
    """Normal, offset, area and corners of each plane, in the frame of the map with sensors."""
    content = json.loads((pathlib.Path(folder) / "map.json").read_text())
    shift = content.get("shift")
    for plane in content["planes"]:
        corners = numpy.concatenate([numpy.reshape(loop["outer"], (-1, 3)) for loop in plane["polygons"]])
        normal = numpy.array(plane["coefficients"][:3])
        if shift:
            corners = corners + shift - numpy.array(GRID)
            normal, corners = (values[..., [0, 2, 1]] * [1, -1, 1] for values in (normal, corners))
        yield normal, -corners.mean(axis=0) @ normal, plane["area"], corners


def counterpart(known, normal, middle):
    """The normal of the plane among those of a map that is the same; None if there is none."""
    found = []
    for other, offset, _, corners in known:
        distance = abs(other @ middle + offset)
        low, high = corners.min(axis=0) - 0.1, corners.max(axis=0) + 0.1
        if abs(other @ normal) > 0.95 and distance < 0.06 and ((low < middle) & (middle < high)).all():
            found.append((distance, tuple(other)))
    return numpy.array(min(found)[1]) if found else None


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    known = list(planes_of(sys.argv[1]))
    areas = {"same side": 0.0, "other side": 0.0, "no counterpart": 0.0}
    for normal, _, area, corners in planes_of(sys.argv[2]):
        other = counterpart(known, normal, corners.mean(axis=0))
        name = "no counterpart" if other is None else "same side" if other @ normal > 0 else "other side"
        areas[name] += area
    total = sum(areas.values())
    for name, area in areas.items():
        print(f"{name}: {area:.1f} m2, {100 * area / total:.1f} %")


if __name__ == "__main__":
    main()
