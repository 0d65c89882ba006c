"""Simulated clouds for the tests: metres, camera frame (x right, y down, z forward)."""

import numpy


# Walls of the room: axis, position in metres.
walls = ((2, 3.5), (0, -2.0), (0, 2.0), (1, -1.2), (1, 1.3))


def turned(angle, x=0.0, z=0.0):
    """Pose T_map_camera at (x, 0, z), turned about y by an angle in radians."""
    pose = numpy.eye(4)
    cosine, sine = numpy.cos(angle), numpy.sin(angle)
    pose[[0, 0, 2, 2], [0, 2, 0, 2]] = cosine, sine, -sine, cosine
    pose[[0, 2], 3] = x, z
    return pose


def room_view(height=60, width=80, noise=0.0, seed=1, pose=numpy.eye(4)):
    """A room of 4 x 2.5 x 3.5 m as a camera at pose T_map_camera in it sees it:
    (height, width, 3) float32, in the frame of the camera.

    noise: metres along the ray, one standard deviation."""
    columns, rows = numpy.meshgrid(
        (numpy.arange(width) - (width - 1) / 2) / (width / 2),
        (numpy.arange(height) - (height - 1) / 2) / (width / 2),
    )
    rays = numpy.dstack([columns, rows, numpy.ones_like(columns)])
    directions, start = rays @ pose[:3, :3].T, pose[:3, 3]
    with numpy.errstate(divide="ignore"):
        distances = numpy.stack(
            [(at - start[axis]) / directions[..., axis] for axis, at in walls]
        )
    distances[distances <= 0] = numpy.inf
    nearest = distances.min(axis=0)
    random = numpy.random.default_rng(seed)
    nearest = nearest + noise * random.standard_normal(nearest.shape)
    return (rays * nearest[..., None]).astype(numpy.float32)


def colors_at(places):
    """Colours of places in the room: (..., 3) uint8. Each channel changes along one axis."""
    return (128 + 100 * numpy.sin(places * (1.5, 2.0, 2.5))).astype(numpy.uint8)


def noisy_wall(points=20000, noise=0.01, seed=1):
    """A wall of 4 x 2 m, 3 m ahead: (points, 3) float32."""
    random = numpy.random.default_rng(seed)
    places = random.uniform((-2, -1, 3), (2, 1, 3), (points, 3))
    places[:, 2] += noise * random.standard_normal(points)
    return places.astype(numpy.float32)
