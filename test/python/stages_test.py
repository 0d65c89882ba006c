"""What the stages find in a simulated room, from the noisy view to its planes."""

import inspect
import pickle
import struct
import unittest
import zlib

import numpy

import acmap
from rooms import noisy_wall, room_view, turned, walls


def off_walls(points):
    return numpy.min([abs(points[:, axis] - at) for axis, at in walls], axis=0)


def pixels_of(png):
    """Pixels of a PNG of 8 bits a channel, without interlacing."""
    at, data, size = 8, b"", None
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        part = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">II", part[:8])
        if kind == b"IDAT":
            data += part
        at += length + 12
    width, height = size
    stride = 3 * width
    data = zlib.decompress(data)
    above, pixels = bytearray(stride), bytearray()
    for row in range(height):
        kind, *line = data[row * (stride + 1):(row + 1) * (stride + 1)]
        for i, value in enumerate(line):
            left, corner = (line[i - 3], above[i - 3]) if i >= 3 else (0, 0)
            up = above[i]
            if kind == 4:
                best = min((abs(up - corner), 0), (abs(left - corner), 1),
                           (abs(left + up - 2 * corner), 2))[1]
                guess = (left, up, corner)[best]
            else:
                guess = (0, left, up, (left + up) // 2)[kind]
            line[i] = (value + guess) % 256
        above = line
        pixels += bytes(line)
    return numpy.frombuffer(pixels, numpy.uint8).reshape(height, width, 3)


def chain(threads):
    view = room_view(120, 160, noise=0.01)
    found = acmap.consolidate(view, keep_sources=True, threads=threads)
    mesh = acmap.triangulate(
        found.points,
        normals=found.normals,
        maximum_edge_length=2.5 * found.report.voxel_size,
        threads=threads,
    )
    normals = acmap.vote_normals(found.points, mesh, threads=threads)
    planes = acmap.find_planes(
        found.points, normals, mesh, source=view, threads=threads
    )
    return view, found, mesh, normals, planes


class Room(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.view, cls.found, cls.mesh, cls.normals, cls.planes = chain(threads=1)

    def test_consolidated_points_lie_on_the_walls(self):
        noise = numpy.median(off_walls(self.view.reshape(-1, 3)))
        self.assertLess(numpy.median(off_walls(self.found.points)), noise / 3)
        lengths = numpy.linalg.norm(self.found.normals, axis=1)
        self.assertTrue(numpy.allclose(lengths, 1, atol=1e-5))
        towards = (self.found.normals * self.found.points).sum(axis=1)
        self.assertLess(numpy.mean(towards > 0), 0.01, "the sensor is the origin")

    def test_sources_are_near_their_points(self):
        points = self.view.reshape(-1, 3)
        of = self.found.representative_of
        self.assertEqual(of.shape, (len(points),))
        reach = 3 * self.found.report.voxel_size
        moved = numpy.linalg.norm(points - self.found.points[of], axis=1)[of >= 0]
        self.assertLess(moved.max(), reach)
        witnesses = points[self.found.witness]
        self.assertLess(numpy.linalg.norm(witnesses - self.found.points, axis=1).max(), reach)

    def test_a_notebook_shows_mesh_and_planes(self):
        for shown in (self.mesh, self.planes):
            picture = pixels_of(shown._repr_png_())
            self.assertEqual(picture.shape, (480, 640, 3))
            is_drawn = (picture != 255).any(axis=2)
            self.assertGreater(is_drawn.mean(), 0.2)
            self.assertTrue((picture[[0, -1]] == 255).all(), "nothing is cut off")
            rows, columns = numpy.nonzero(is_drawn)
            reach = max(numpy.ptp(rows) / 480, numpy.ptp(columns) / 640)
            self.assertGreater(reach, 0.85, "the picture is filled")
        colors = pixels_of(self.planes._repr_png_()).reshape(-1, 3)
        self.assertGreaterEqual(len(numpy.unique(colors, axis=0)), 1 + len(self.planes.patches))

    def test_without_points_there_is_no_picture(self):
        mesh = acmap.triangulate(numpy.zeros((0, 3), numpy.float32))
        self.assertIsNone(mesh._repr_png_())

    def test_a_mesh_is_pickled_with_its_points(self):
        again = pickle.loads(pickle.dumps(self.mesh))
        self.assertEqual(again.points.tobytes(), self.mesh.points.tobytes())
        self.assertEqual(again._repr_png_(), self.mesh._repr_png_())

    def test_mesh_is_open_and_manifold(self):
        edges = numpy.sort(self.mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        _, uses = numpy.unique(edges, axis=0, return_counts=True)
        self.assertEqual(uses.max(), 2)
        self.assertEqual((uses == 1).sum(), self.mesh.report.boundary_edges)
        self.assertEqual(len(self.mesh.triangles), self.mesh.report.triangles)

    def test_every_wall_is_a_plane(self):
        found = {
            (int(abs(patch.coefficients[:3]).argmax()), round(float(at), 1))
            for patch in self.planes.patches
            for at in [patch.center[abs(patch.coefficients[:3]).argmax()]]
        }
        self.assertEqual(found, set(walls))

    def test_patches_describe_their_points(self):
        points = self.view.reshape(-1, 3)
        self.assertEqual(self.planes.source_labels.shape, (len(points),))
        for number, patch in enumerate(self.planes.patches):
            normal, offset = patch.coefficients[:3], patch.coefficients[3]
            self.assertAlmostEqual(numpy.linalg.norm(normal), 1)
            mine = points[self.planes.source_labels == number]
            self.assertGreater(len(mine), 100)
            self.assertLess(numpy.median(abs(mine @ normal + offset)), 0.015)
            self.assertGreater(patch.rmse, 0.002)  # same name as in JSON; the noise is
                                                   # 0.01
            self.assertLess(patch.rmse, 0.02)
            self.assertFalse(hasattr(patch, "rms"))
            self.assertTrue((numpy.linalg.eigvalsh(patch.covariance) > 0).all())
            self.assertAlmostEqual(patch.axis_u @ normal, 0)
            self.assertAlmostEqual(patch.center @ normal + offset, 0)
            for polygon in patch.polygons:
                self.assertLess(abs(polygon.outer @ normal + offset).max(), 1e-3)

    def test_creases_lie_where_walls_meet(self):
        off = numpy.sort([abs(self.found.points[:, axis] - at) for axis, at in walls], axis=0)
        is_crease = self.normals.vertex_class >= 2
        self.assertGreater(is_crease.sum(), 20)
        self.assertLess(numpy.median(off[1][is_crease]), 0.1)
        self.assertGreater(numpy.median(off[1][self.normals.vertex_class == 1]), 0.2)

    def test_threads_do_not_matter(self):
        _, found, mesh, normals, planes = chain(threads=2)
        self.assertEqual(found.points.tobytes(), self.found.points.tobytes())
        self.assertEqual(mesh.triangles.tobytes(), self.mesh.triangles.tobytes())
        self.assertEqual(normals.normals.tobytes(), self.normals.normals.tobytes())
        self.assertEqual(planes.labels.tobytes(), self.planes.labels.tobytes())
        for one, other in zip(planes.patches, self.planes.patches):
            self.assertEqual(one.coefficients.tobytes(), other.coefficients.tobytes())
            self.assertEqual(one.polygons[0].outer.tobytes(), other.polygons[0].outer.tobytes())


class Settings(unittest.TestCase):
    def test_sensors_turn_the_normals(self):
        wall = noisy_wall()
        for origin, sign in (((0, 0, 0), -1), ((0, 0, 6), 1)):
            normals = acmap.consolidate(wall, sensor_origin=origin).normals
            self.assertTrue((sign * normals[:, 2] > 0).all())
        unknown = acmap.consolidate(wall, sensor_origin=None)
        self.assertFalse(unknown.report.sensors_fit)
        places = numpy.array([[0, 0, 0], [0, 0, 6]], numpy.float32)
        records = numpy.zeros(len(wall), [("label", "u1"), ("view", "i4")])
        records["view"] = 1
        seen = acmap.consolidate(wall, viewpoints=places, view=records["view"])
        self.assertTrue((seen.normals[:, 2] > 0).all())

    def test_up_turns_faces_without_a_sensor(self):
        ground = numpy.zeros((900, 3), numpy.float32)
        ground[:, :2] = numpy.stack(numpy.divmod(numpy.arange(900), 30), axis=1)
        ground[:, 2] = 100

        def heights(**settings):
            a, b, c = (ground[acmap.triangulate(ground, **settings).triangles[:, i]] for i in range(3))
            return numpy.cross(b - a, c - a)[:, 2]

        self.assertTrue((heights() < 0).all())
        self.assertTrue((heights(up=(0, 0, 2)) > 0).all())
        with self.assertRaises(ValueError):
            acmap.triangulate(ground, up=(0, 0, 0))

    def test_what_is_not_asked_for_is_none(self):
        view = room_view()
        mesh = acmap.triangulate(view)
        self.assertIsNone(mesh.wall_depth)
        self.assertIsNone(acmap.consolidate(view).representative_of)
        self.assertIsNone(acmap.vote_normals(view, mesh).curvatures)
        depth = acmap.triangulate(view, compute_wall_depth=True).wall_depth
        self.assertEqual(depth.shape, (len(mesh.triangles),))

    def test_rules(self):
        wall = noisy_wall(5000)
        guarded, dense = (acmap.triangulate(wall, rule=rule) for rule in ("guarded", "dense"))
        self.assertGreater(dense.report.triangles, guarded.report.triangles)
        strict = acmap.triangulate(wall, rule="strict", compute_wall_depth=True)
        self.assertGreater(strict.report.walls, 3)
        self.assertEqual((guarded.report.walls, guarded.report.crowded_edges), (0, 0))
        self.assertEqual(strict.wall_depth[0], 0)

    def test_paper_thresholds_find_the_wall(self):
        wall = noisy_wall(2000)
        normals = numpy.zeros_like(wall)
        normals[:, 2] = -5  # of any length
        planes = acmap.find_planes(wall, normals, noise_driven=False, member_distance=5)
        self.assertEqual(len(planes.patches), 1)
        self.assertEqual(planes.patches[0].support, 2000)
        self.assertEqual(planes.patches[0].polygons, [])
        self.assertEqual(planes.report.tested_hypotheses, 1)
        self.assertEqual(planes.report.reestimations, 1999)
        planes = acmap.find_planes(wall, normals, noise_driven=False)
        self.assertEqual(len(planes.patches), 1, "0.8 m around any member are the wall")
        planes = acmap.find_planes(
            wall, normals, noise_driven=False, supporter_reach="hypothesis"
        )
        self.assertGreater(len(planes.patches), 4, "0.8 m around a point are not the wall")

    def test_noise_decides_by_default(self):
        wall = noisy_wall(2000)
        normals = numpy.zeros_like(wall)
        normals[:, 2] = -1
        default = acmap.find_planes(wall, normals)
        chosen = acmap.find_planes(wall, normals, noise_driven=True)
        self.assertEqual(default.labels.tolist(), chosen.labels.tolist())
        self.assertEqual(default.report.tested_hypotheses, 0)

    def test_votes_of_the_paper(self):
        view = room_view(noise=0.02)
        mesh = acmap.triangulate(view)
        ours, paper = (acmap.vote_normals(view, mesh, paper=paper) for paper in (False, True))
        self.assertGreater(paper.report.votes, ours.report.votes, "near triangles vote too")
        self.assertLess(paper.report.unknown, ours.report.unknown + 1)
        page = acmap.vote_normals(
            view, mesh, paper=True, crease_weight=2, corner_weight=2
        )
        self.assertEqual(page.vertex_class.tolist(), paper.vertex_class.tolist())

    def test_poses_are_adjusted(self):
        truth = numpy.array([turned(0.15 * i, 0.05 * i, 0.02 * i) for i in range(5)])
        given = truth.copy()
        given[:, 1, 3] += 0.02 * numpy.arange(5)
        views = [room_view(240, 320, noise=0.004, seed=i, pose=pose)
                 for i, pose in enumerate(truth)]
        sigmas = [numpy.full(view.shape[:2], 0.004, numpy.float32) for view in views]
        for settings in ({}, {"sigmas": sigmas, "threads": 1}):
            adjusted = acmap.adjust(views, given, odometry_length=0.02, **settings)
            report = adjusted.report
            self.assertEqual(report.outcome, "adjusted", report.reason)
            self.assertLess(abs(adjusted.poses - truth)[:, :3, 3].max(), 0.004)
            self.assertLess(report.thickness_after, report.thickness_before / 3)
            self.assertEqual(report.views, 5)
            self.assertEqual(report.moved.shape, (5,))
            self.assertEqual(report.position_sd.shape, (5,))
            self.assertGreater(report.rounds[0].landmarks, 0)
            self.assertAlmostEqual(report.rays_after.near_share, 0, places=2)
        again = acmap.adjust(views, given, odometry_length=0.02, sigmas=sigmas, threads=2)
        self.assertEqual(again.poses.tobytes(), adjusted.poses.tobytes())
        kept = acmap.adjust(views, truth, odometry_length=0.02)
        self.assertEqual(kept.report.outcome, "kept")
        self.assertEqual(kept.poses.tobytes(), truth.tobytes())

    def test_help_tells_units_and_shapes(self):
        for name in ("consolidate", "triangulate", "vote_normals", "find_planes", "rectify", "adjust"):
            text = inspect.getdoc(getattr(acmap, name))
            for word in ("float32", "metres", "threads", "Returns"):
                self.assertIn(word, text, name)
        self.assertRegex(acmap.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
