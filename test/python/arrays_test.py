"""What goes in is read where it is; what comes out outlives whoever made it."""

import gc
import mmap
import subprocess
import sys
import unittest

import numpy

import acmap
from rooms import noisy_wall, room_view


def address(array):
    return array.__array_interface__["data"][0]


class Inputs(unittest.TestCase):
    def setUp(self):
        self.points = room_view().reshape(-1, 3)
        self.triangles = acmap.triangulate(self.points).triangles

    def expect_same_mesh(self, points, expected=None):
        mesh = acmap.triangulate(points)
        expected = self.triangles if expected is None else expected
        self.assertEqual(mesh.triangles.tobytes(), expected.tobytes())

    def test_big_cloud_is_not_copied(self):
        script = """if True:
            import resource
            import numpy, acmap
            points = numpy.empty((6_000_000, 3), numpy.float32)
            numpy.random.default_rng(1).random(out=points, dtype=numpy.float32)
            points[:, 2] = 3
            acmap.consolidate(points[:1000], voxel_size=0.1)
            peak = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
            before = peak()
            found = acmap.consolidate(points, voxel_size=0.1, threads=1)
            assert found.report.points == len(points)
            print(peak() - before)"""
        run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
        self.assertEqual(run.stderr, "")
        self.assertLess(int(run.stdout), 36, "MB; the points are 72")

    def test_columns_of_a_wider_array(self):
        wide = numpy.full((len(self.points), 7), 1e6, numpy.float32)
        wide[:, 2:5] = self.points
        self.expect_same_mesh(wide[:, 2:5])

    def test_fields_of_records(self):
        records = numpy.zeros(
            len(self.points), [("label", "u1"), ("xyz", "f4", 3), ("stamp", "f8")]
        )
        records["xyz"] = self.points
        self.expect_same_mesh(records["xyz"])

    def test_every_second_point(self):
        expected = acmap.triangulate(self.points[::2].copy()).triangles
        self.expect_same_mesh(self.points[::2], expected)

    def test_read_only_file_in_memory(self):
        with mmap.mmap(-1, self.points.nbytes) as memory:
            memory.write(self.points.tobytes())
            view = memoryview(memory).toreadonly()
            points = numpy.frombuffer(view, numpy.float32).reshape(-1, 3)
            self.assertFalse(points.flags.writeable)
            self.expect_same_mesh(points)
            del points, view
            gc.collect()

    def test_rows_of_an_image(self):
        view = room_view()
        expected = acmap.triangulate(view).triangles
        wide = numpy.full((*view.shape[:2], 4), 1e6, numpy.float32)
        wide[..., :3] = view
        self.expect_same_mesh(wide[..., :3], expected)
        self.expect_same_mesh(view[:, :1], acmap.triangulate(view[:, 0].copy()).triangles)

    def test_inputs_are_not_written(self):
        before = self.points.tobytes()
        found = acmap.consolidate(self.points)
        mesh = acmap.triangulate(self.points)
        normals = acmap.vote_normals(self.points, mesh)
        acmap.find_planes(self.points, normals, mesh, source=self.points)
        acmap.rectify([self.points], numpy.eye(4)[None])
        self.assertGreater(len(found.points), 0)
        self.assertEqual(self.points.tobytes(), before)


class Outputs(unittest.TestCase):
    def test_columns_look_at_one_record(self):
        found = acmap.consolidate(noisy_wall())
        self.assertFalse(found.points.flags.owndata)
        self.assertEqual(address(found.normals) - address(found.points), 12)
        self.assertEqual(found.points.strides, found.curvature.strides + (4,))

    def test_same_array_at_every_look(self):
        mesh = acmap.triangulate(room_view())
        self.assertEqual(address(mesh.triangles), address(mesh.triangles))
        mesh.triangles[0] = 0
        self.assertEqual(mesh.triangles[0].tolist(), [0, 0, 0])

    def test_a_mesh_is_handed_on_as_it_is(self):
        points = room_view()
        mesh = acmap.triangulate(points)
        whole = acmap.vote_normals(points, mesh)
        mesh.triangles[:] = 0  # visible to the next stage, as there is no copy
        self.assertEqual(acmap.vote_normals(points, mesh).report.unknown, points.size // 3)
        self.assertEqual(whole.report.unknown, 0)
        mesh.triangles[0, 0] = points.size
        with self.assertRaisesRegex(ValueError, "corner"):
            acmap.vote_normals(points, mesh)

    def test_arrays_outlive_their_objects(self):
        points = room_view(noise=0.01)
        found = acmap.consolidate(points, keep_sources=True)
        mesh = acmap.triangulate(found.points, normals=found.normals)
        normals = acmap.vote_normals(found.points, mesh, compute_curvatures=True)
        planes = acmap.find_planes(found.points, normals, mesh)
        rectified = acmap.rectify([found.points], numpy.eye(4)[None])
        polygon = planes.patches[0].polygons[0]
        arrays = [found.points, found.normals, found.curvature, found.witness]
        arrays += [found.representative_of, mesh.triangles, normals.normals]
        arrays += [normals.directions, normals.saliency, normals.vertex_class]
        arrays += [normals.curvatures, normals.curvature_directions, planes.labels]
        arrays += [planes.patches[0].coefficients, planes.patches[0].covariance]
        arrays += [polygon.outer, rectified.poses, rectified.report.moved]
        copies = [array.copy() for array in arrays]
        del found, mesh, normals, planes, rectified, polygon
        gc.collect()
        rubbish = [numpy.full(array.nbytes, 0xAA, numpy.uint8) for array in arrays]
        self.assertEqual(len(rubbish), len(arrays))
        for array, copy in zip(arrays, copies):
            self.assertEqual(array.tobytes(), copy.tobytes())

    def test_everything_goes_with_the_last_array(self):
        script = """if True:
            import resource
            import acmap
            from rooms import noisy_wall
            points = noisy_wall(500_000)
            run = lambda: acmap.consolidate(points, voxel_size=0.1, keep_sources=True)
            peak = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
            run()
            run()
            before = peak()
            for again in range(20):  # 2 MB each
                run()
            print(peak() - before)"""
        run = subprocess.run(
            [sys.executable, "-c", script], capture_output=True, text=True, cwd=sys.path[0]
        )
        self.assertEqual(run.stderr, "")
        self.assertLess(int(run.stdout), 20, "MB; all of them are 40")


if __name__ == "__main__":
    unittest.main()
