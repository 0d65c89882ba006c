"""Pictures of meshes, planes and maps. Metres, y down."""

import contextlib

import numpy as np
from matplotlib import pyplot
from matplotlib.collections import PolyCollection

eye = np.array([0.3, -0.15, -1.9])  # camera position of the pictures of the room
surface, crease = np.array([0.72, 0.78, 0.86]), np.array([0.85, 0.25, 0.15])


@contextlib.contextmanager
def two_pictures(path, across=True):
    """Two axes, side by side or one above the other; saves the figure at the end."""
    figure, axes = pyplot.subplots(
        *((1, 2) if across else (2, 1)),
        figsize=(9, 3.3) if across else (9, 6),
        layout="constrained",
    )
    yield axes
    figure.savefig(path, dpi=80)
    pyplot.close(figure)


def seen_from_eye(places):
    toward = places - eye
    return toward[..., :2] / toward[..., 2:] * (1, -1), toward[..., 2]


def add_shapes(axes, shapes, colors, title, **style):
    """Draws polygons in space, the farthest first."""
    places = [seen_from_eye(shape) for shape in shapes]
    order = np.argsort([-depth.mean() for _, depth in places])
    axes.add_collection(
        PolyCollection(
            [places[i][0] for i in order],
            facecolors=[colors[i] for i in order],
            **style,
        )
    )
    axes.set(xlim=(-0.59, 0.44), ylim=(-0.38, 0.34), aspect="equal", title=title)
    axes.set_axis_off()


def draw_mesh(axes, points, triangles, title, is_crease=None):
    """Draws a shaded mesh; triangles at a crease are red."""
    corners = points[triangles]
    sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sides /= np.linalg.norm(sides, axis=1, keepdims=True)
    light = 0.35 + 0.65 * np.abs(sides @ np.array([0.42, -0.76, -0.5]))
    light = np.round(20 * light) / 20  # fewer shades give smaller files
    colors = np.tile(surface, (len(triangles), 1))
    if is_crease is not None:
        colors[is_crease[triangles].sum(axis=1) >= 2] = crease
    shaded = colors * light[:, None]
    add_shapes(axes, corners, shaded, title, antialiased=False)


def draw_planes(axes, patches, title):
    rims = [polygon.outer for patch in patches for polygon in patch.polygons]
    numbers = [i for i, patch in enumerate(patches) for _ in patch.polygons]
    colors = [pyplot.cm.Set2(number % 8) for number in numbers]
    add_shapes(axes, rims, colors, title, edgecolors="black", linewidths=0.8)


def draw_map(axes, clouds, poses, title):
    """Plan of the points between floor and ceiling, and the camera trajectory."""
    for cloud, pose in zip(clouds, poses):
        walls = cloud[np.abs(cloud[:, 1]) < 0.9]
        places = walls @ pose[:3, :3].T + pose[:3, 3]
        axes.plot(places[:, 2], places[:, 0], ",", color="#20508099", rasterized=True)
    axes.plot(poses[:, 2, 3], poses[:, 0, 3], ".-", color="#d05020", markersize=4)
    axes.set(aspect="equal", xlim=(-0.5, 17), ylim=(3.4, -1.7), title=title)
    axes.set(xlabel="z (m)", ylabel="x (m)")
