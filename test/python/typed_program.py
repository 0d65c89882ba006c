"""What a user writes with types; checked by mypy --strict, never run."""

import pathlib
from typing import Any, List, Optional

import numpy
from numpy.typing import NDArray

import acmap

Points = NDArray[numpy.float32]


def told(fraction: float, step: str) -> None:
    print(f"{step}: {fraction:.0%}")


def planes_of(path: pathlib.Path) -> List[acmap.PlanePatch]:
    cloud = acmap.read_cloud(path)
    points: Points = cloud.points
    found = acmap.consolidate(points, sensor_origin=(0, 0, 1.5), progress=told)
    mesh = acmap.triangulate(found.points, normals=found.normals, up=cloud.up)
    acmap.write_mesh(path.with_suffix(".ply"), found.points, mesh, found.normals)
    normals = acmap.vote_normals(found.points, mesh, threads=2)
    planes = acmap.find_planes(found.points, normals, mesh.triangles, source=points)
    labels: NDArray[numpy.int32] = planes.labels
    print(labels.max(), planes.report.seconds[0][1], found.report.voxel_size)
    return planes.patches


def straightened(clouds: List[Points], poses: NDArray[numpy.float64]) -> NDArray[numpy.float64]:
    rectified = acmap.rectify(clouds, poses, up=[0, -1, 0], mode="guarded")
    return acmap.adjust(tuple(clouds), rectified.poses).poses


def mapped(views: List[Any], folder: str) -> Optional[List[float]]:
    mapping = acmap.CompactMapping(sensor="tof", up=(0, -1, 0), folder=pathlib.Path(folder))
    for points, colors in views:
        mapping.add_observation(points, colors)
    try:
        compact = mapping.compute(lambda fraction, step: fraction < 0.5)
    except acmap.Cancelled:
        compact = acmap.read_map(folder)
    names: List[str] = compact.save(folder, color_tolerance=0)
    area: float = sum(patch.area for patch in compact.planes) - compact.area
    texels: NDArray[numpy.uint8] = compact.charts[0].colors
    print(compact.report.outcome, names, area, texels.shape, compact.rooms[0].planes[0] + 1)
    return compact.up
