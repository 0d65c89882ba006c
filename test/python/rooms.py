"""Simulated clouds for the tests: metres, camera frame (x right, y down, z forward)."""

import numpy


def room_view(height=60, width=80, noise=0.0, seed=1):
    """A room of 4 x 2.5 x 3.5 m as a camera in it sees it: (height, width, 3) float32.

    noise: metres along the ray, one standard deviation."""
    columns, rows = numpy.meshgrid(
        (numpy.arange(width) - (width - 1) / 2) / (width / 2),
        (numpy.arange(height) - (height - 1) / 2) / (width / 2),
    )
    rays = numpy.dstack([columns, rows, numpy.ones_like(columns)])
    with numpy.errstate(divide="ignore"):
        distances = numpy.stack(
            [3.5 / rays[..., 2]]
            + [at / rays[..., axis] for axis, at in ((0, -2), (0, 2), (1, -1.2), (1, 1.3))]
        )
    distances[distances <= 0] = numpy.inf
    nearest = distances.min(axis=0)
    random = numpy.random.default_rng(seed)
    nearest = nearest + noise * random.standard_normal(nearest.shape)
    return (rays * nearest[..., None]).astype(numpy.float32)


def noisy_wall(points=20000, noise=0.01, seed=1):
    """A wall of 4 x 2 m, 3 m ahead: (points, 3) float32."""
    random = numpy.random.default_rng(seed)
    places = random.uniform((-2, -1, 3), (2, 1, 3), (points, 3))
    places[:, 2] += noise * random.standard_normal(points)
    return places.astype(numpy.float32)
