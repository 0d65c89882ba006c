"""Scenes of rectangles, and simulated views of a noisy range camera, in colour.
Metres, y down."""

import numpy as np


def rectangle(axis, at, least, most):
    """Perpendicular to an axis (0: x, 1: y, 2: z); least and most ignore this axis."""
    return axis, at, np.array(least, float), np.array(most, float)


def box(least, most):
    return [
        rectangle(axis, corner[axis], least, most)
        for axis in range(3)
        for corner in (least, most)
    ]


def room():
    """4 x 2.5 x 3.5 m, with a recessed door in front and a box on the floor."""
    left, right, ceiling, ground, end = -2.0, 2.0, -1.2, 1.3, 3.5
    top, recess = -0.75, end + 0.25
    return [
        rectangle(1, ground, (left, 0, 0), (right, 0, end)),
        rectangle(1, ceiling, (left, 0, 0), (right, 0, end)),
        rectangle(0, left, (0, ceiling, 0), (0, ground, end)),
        rectangle(0, right, (0, ceiling, 0), (0, ground, end)),
        rectangle(2, end, (left, ceiling, 0), (0.5, ground, 0)),
        rectangle(2, end, (1.4, ceiling, 0), (right, ground, 0)),
        rectangle(2, end, (0.5, ceiling, 0), (1.4, top, 0)),
        rectangle(2, recess, (0.5, top, 0), (1.4, ground, 0)),
        rectangle(0, 0.5, (0, top, end), (0, ground, recess)),
        rectangle(0, 1.4, (0, top, end), (0, ground, recess)),
        rectangle(1, top, (0.5, 0, end), (1.4, 0, recess)),
        rectangle(1, ground, (0.5, 0, end), (1.4, 0, recess)),
    ] + box((-1.3, 0.65, 2.1), (-0.5, ground, 2.7))


def corridor(length=16.0):
    """2.4 m wide and closed at one end, with pillars along both walls."""
    ceiling, ground = -1.2, 1.3
    scene = [
        rectangle(0, -1.2, (0, ceiling, -2), (0, ground, length)),
        rectangle(0, 1.2, (0, ceiling, -2), (0, ground, length)),
        rectangle(1, ground, (-1.2, 0, -2), (1.2, 0, length)),
        rectangle(1, ceiling, (-1.2, 0, -2), (1.2, 0, length)),
        rectangle(2, length, (-1.2, ceiling, 0), (1.2, ground, 0)),
    ]
    for z in np.arange(1.5, length, 3.1):
        scene += box((-1.2, ceiling, z), (-1.0, ground, z + 0.4))
        scene += box((1.0, ceiling, z + 1.4), (1.2, ground, z + 1.8))
    return scene


def look_along(places):
    """Poses T_map_camera at x = 0 and z = places, turned slightly to left and right."""
    poses = np.tile(np.eye(4), (len(places), 1, 1))
    poses[:, 2, 3] = places
    turns = np.radians(12) * np.sin(np.arange(len(places)) * np.pi / 2)
    poses[:, 0, 0] = poses[:, 2, 2] = np.cos(turns)
    poses[:, 0, 2] = np.sin(turns)
    poses[:, 2, 0] = -np.sin(turns)
    return poses


def noisy_view(scene, pose, height, width, seed, reach=6.0):
    """Points seen by a camera at pose T_map_camera: (height, width, 3) float32 in its
    frame, with noise along the rays that grows as for stereo; NaN beyond its reach."""
    columns = (np.arange(width) - (width - 1) / 2) / (0.52 * width)
    rows = (np.arange(height) - (height - 1) / 2) / (0.52 * width)
    rays = np.dstack([*np.meshgrid(columns, rows), np.ones((height, width))])
    directions, start = rays @ pose[:3, :3].T, pose[:3, 3]
    depth = np.full((height, width), np.inf)
    for axis, at, least, most in scene:
        with np.errstate(divide="ignore", invalid="ignore"):
            t = (at - start[axis]) / directions[..., axis]
            places = start + t[..., None] * directions
            inside = (places >= least) & (places <= most)
        inside[..., axis] = True
        hit = inside.all(axis=-1) & (t > 0)
        depth[hit] = np.minimum(depth, t)[hit]
    depth[depth > reach] = np.nan
    noise = np.random.default_rng(seed).standard_normal(depth.shape)
    depth += noise * np.maximum(0.006, 0.0015 * depth**2)
    return (rays * depth[..., None]).astype(np.float32)


def colors_of(view, pose):
    """Colours of a view from pose T_map_camera: (height, width, 3) uint8. Red changes
    along x, green along y and blue along z; grey where nothing was measured."""
    places = view @ pose[:3, :3].T + pose[:3, 3]
    waves = np.nan_to_num(np.sin(places * (2, 3, 4)))
    return (128 + 100 * waves).astype(np.uint8)
