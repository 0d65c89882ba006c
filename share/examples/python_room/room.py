"""From a noisy view of a room to its planes, from a few coloured views to a map of textured
planes, and from a bent corridor to a straight one.

Each `# %%` begins a cell, for editors that run a script as a notebook. The script prints
its results. Usage: room.py [FOLDER]; the pictures are written into the folder.
Needs numpy and acmap; pictures need matplotlib. Metres; camera frame: x right, y down,
z forward.
"""

# %% Imports
import pathlib
import sys

import numpy as np

import acmap

folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None
if folder:
    folder.mkdir(parents=True, exist_ok=True)
    try:
        import matplotlib

        matplotlib.use("Agg")
        from drawing import draw_map, draw_mesh, draw_planes, two_pictures
    except ImportError:
        print("no pictures: matplotlib is not installed (Debian: python3-matplotlib)")
        folder = None

# %% A room and a corridor of rectangles, and the view of a camera in the room
from scenes import colors_of, corridor, look_along, noisy_view, room

view = noisy_view(room(), np.eye(4), height=216, width=288, seed=1)
print(f"view: {view.shape}, {view.dtype}")

# %% One point per voxel, on the plane of the points around it
found = acmap.consolidate(view)
print(
    f"consolidated: {found.report.points} points to {len(found.points)}, voxels of "
    f"{100 * found.report.voxel_size:.1f} cm, noise {1000 * found.report.sigma:.1f} mm"
)

# %% A mesh of the raw points, and a mesh of the consolidated points
raw = acmap.triangulate(view)
mesh = acmap.triangulate(
    found.points,
    normals=found.normals,
    maximum_edge_length=2.5 * found.report.voxel_size,
)
for name, made in (("raw", raw), ("consolidated", mesh)):
    share = made.report.boundary_edges / made.report.edges
    print(f"{name} mesh: {len(made.triangles)} triangles, {share:.1%} boundary edges")
if folder:
    with two_pictures(folder / "python_mesh.png") as (left, right):
        draw_mesh(left, view.reshape(-1, 3), raw.triangles, "as it was seen")
        draw_mesh(right, found.points, mesh.triangles, "consolidated")

# %% Normals, creases and planes; the planes are fitted to the points of the view
normals = acmap.vote_normals(found.points, mesh)
planes = acmap.find_planes(found.points, normals, mesh, source=view, regular=True)
on_planes = np.mean(planes.source_labels >= 0)
print(f"planes: {len(planes.patches)}, with {on_planes:.1%} of the points")
for patch in planes.patches:
    a, b, c, d = patch.coefficients
    sigma = 1000 * np.sqrt(patch.covariance[2, 2])
    print(
        f"  {a:+.3f} x {b:+.3f} y {c:+.3f} z {d:+.3f} = 0 (+- {sigma:.2f} mm), "
        f"{patch.area:.2f} m2"
    )
if folder:
    with two_pictures(folder / "python_planes.png") as (left, right):
        draw_mesh(
            left, found.points, mesh.triangles, "creases", normals.vertex_class >= 2
        )
        draw_planes(right, planes.patches, "planes and their rims")

# %% A compact map of a few coloured views: textured planes; all steps in one object
mapping = acmap.CompactMapping(rectify=False)  # these poses are exact
for seed, pose in enumerate(look_along(np.arange(0, 1, 0.25))):
    seen_points = noisy_view(room(), pose, height=108, width=144, seed=seed)
    mapping.add_observation(seen_points, colors_of(seen_points, pose), pose)
compact = mapping.compute()
texels = compact.report.texture
print(
    f"map: {len(compact.planes)} planes, {len(compact.charts)} textures, "
    f"{texels.seen / texels.texels:.1%} of their texels seen"
)
for chart in compact.charts:
    height, width = chart.kinds.shape
    area = compact.planes[chart.plane].area
    print(
        f"  plane {chart.plane}: {area:.2f} m2, {width} x {height} texels, seen by the "
        f"observations {compact.observations[chart.plane]}"
    )

# %% A trajectory through a corridor, and odometry that drifts to the side
scene = corridor()
truth = look_along(np.arange(0.3, 12, 0.4))
actions = np.linalg.inv(truth[:-1]) @ truth[1:]
random = np.random.default_rng(2)
poses = [truth[0]]
for action in actions:
    turn = np.radians(0.4) + np.radians(0.1) * random.standard_normal()
    drift = np.eye(4)
    c, s = np.cos(turn), np.sin(turn)
    drift[[0, 0, 2, 2], [0, 2, 0, 2]] = c, s, -s, c
    poses.append(poses[-1] @ action @ drift)
poses = np.array(poses)
views = [noisy_view(scene, pose, 90, 120, seed=i) for i, pose in enumerate(truth)]
seen = [acmap.consolidate(view, voxel_size=0.1) for view in views]

# %% The poses at which the observations are consistent
rectified = acmap.rectify(
    [cloud.points for cloud in seen], poses, normals=[cloud.normals for cloud in seen]
)


def farthest(found_poses):
    return np.linalg.norm(found_poses[:, :3, 3] - truth[:, :3, 3], axis=1).max()


print(f"rectification: {rectified.report.outcome} ({rectified.report.reason})")
before, after = farthest(poses), farthest(rectified.poses)
print(f"farthest pose: {before:.2f} m off before, {after:.2f} m after")
if folder:
    clouds = [cloud.points for cloud in seen]
    with two_pictures(folder / "python_corridor.png", across=False) as (above, below):
        draw_map(above, clouds, poses, "by odometry")
        draw_map(below, clouds, rectified.poses, "rectified")
