"""The module and the tools find the same in the same cloud, byte for byte."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

import acmap
from rooms import noisy_wall, room_view

programs = pathlib.Path(os.environ["ACMAP_BIN"])


def write_pcd(path, points):
    """points: (n, 3) or (h, w, 3)."""
    height, width = points.shape[:2] if points.ndim == 3 else (1, len(points))
    header = (
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
        f"WIDTH {width}\nHEIGHT {height}\nVIEWPOINT 0 0 0 1 0 0 0\n"
        f"POINTS {width * height}\nDATA binary\n"
    )
    path.write_bytes(header.encode() + points.tobytes())


class SameAsTheTools(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_tool(self, name, *arguments):
        command = [programs / name, *(str(argument) for argument in arguments)]
        run = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_meshes(self):
        for name, points in (("view", room_view(noise=0.002)), ("wall", noisy_wall(3000))):
            for rule in ("guarded", "dense", "strict"):
                with self.subTest(name, rule=rule):
                    cloud = self.folder / "cloud.pcd"
                    tools, ours = self.folder / "tools.ply", self.folder / "ours.ply"
                    write_pcd(cloud, points)
                    self.run_tool("pcl_dewall_surface", cloud, tools, "--rule", rule)
                    acmap.write_mesh(str(ours), points, acmap.triangulate(points, rule=rule))
                    self.assertEqual(ours.read_bytes(), tools.read_bytes())

    def test_consolidated_meshes(self):
        points = room_view(120, 160, noise=0.01)
        cloud, tools = self.folder / "cloud.pcd", self.folder / "tools.ply"
        write_pcd(cloud, points)
        self.run_tool("pcl_dewall_surface", cloud, tools, "--consolidate")
        found = acmap.consolidate(points)
        mesh = acmap.triangulate(
            found.points,
            normals=found.normals,
            maximum_edge_length=2.5 * found.report.voxel_size,
        )
        read = acmap.read_cloud(str(tools))
        self.assertEqual(read.points.tobytes(), found.points.tobytes())
        self.assertEqual(read.fields["normal_z"].tobytes(), found.normals[:, 2].tobytes())
        faces = acmap.read_mesh(str(tools))
        self.assertEqual(faces.triangles.tobytes(), mesh.triangles.tobytes())

    def test_planes(self):
        found = acmap.consolidate(room_view(120, 160, noise=0.01))
        mesh = acmap.triangulate(found.points, normals=found.normals)
        file, planes = self.folder / "mesh.ply", self.folder / "planes.json"
        acmap.write_mesh(str(file), found.points, mesh, found.normals)
        self.run_tool("pcl_plane_extraction", file, planes)
        normals = acmap.vote_normals(found.points, mesh)
        ours = acmap.find_planes(found.points, normals, mesh)
        theirs = json.loads(planes.read_text())["planes"]
        self.assertEqual(
            [patch.coefficients.tolist() for patch in ours.patches],
            [plane["coefficients"] for plane in theirs],
        )
        self.assertEqual(
            [patch.support for patch in ours.patches], [plane["support"] for plane in theirs]
        )

    def test_clouds_are_read_as_they_are(self):
        view = room_view()
        cloud = self.folder / "cloud.pcd"
        write_pcd(cloud, view)
        read = acmap.read_cloud(str(cloud))
        self.assertEqual(read.points.shape, view.shape)
        self.assertEqual(read.points.tobytes(), view.tobytes())
        self.assertEqual(read.sensor_origin.tolist(), [0, 0, 0])
        self.assertEqual(read.sensor_orientation.tolist(), [0, 0, 0, 1])
        self.assertIsNone(read.up)
        again = acmap.triangulate(read.points).triangles
        self.assertEqual(again.tobytes(), acmap.triangulate(view).triangles.tobytes())


if __name__ == "__main__":
    unittest.main()
