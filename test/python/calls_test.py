"""Ugly inputs, exceptions, progress, signals, threads."""

import signal
import threading
import time
import unittest

import numpy

import acmap
from rooms import noisy_wall, room_view

points = noisy_wall(2000)
mesh = acmap.triangulate(points)
poses = numpy.eye(4)[None]
two_poses = numpy.repeat(poses, 2, axis=0)

# Calls each function with one cloud.
functions = {
    "consolidate": lambda cloud, **settings: acmap.consolidate(cloud, **settings),
    "triangulate": lambda cloud, **settings: acmap.triangulate(cloud, **settings),
    "vote_normals": lambda cloud, **settings: acmap.vote_normals(cloud, mesh, **settings),
    "find_planes": lambda cloud, **settings: acmap.find_planes(cloud, cloud, **settings),
    "rectify": lambda cloud, **settings: acmap.rectify([cloud, cloud], two_poses, **settings),
    "adjust": lambda cloud, **settings: acmap.adjust([cloud, cloud], two_poses, **settings),
}


class UglyInputs(unittest.TestCase):
    def expect_error(self, error, text, call):
        with self.assertRaisesRegex(error, text):
            call()

    def test_what_is_no_array_of_float32(self):
        for name, function in functions.items():
            for cloud in ([[0, 0, 1]], None, "points", memoryview(points)):
                with self.subTest(name, cloud=type(cloud)):
                    self.expect_error(TypeError, "numpy", lambda: function(cloud))
            for kind in (">f4", "f8", "f2", "i4", "O", "c8"):
                with self.subTest(name, kind=kind):
                    self.expect_error(
                        TypeError,
                        r"refused.*pass .*\.astype\(numpy\.float32\)",
                        lambda: function(points.astype(kind)),
                    )

    def test_shapes_and_strides(self):
        view = room_view()
        for name, function in functions.items():
            for cloud in (points[0], points[:, :2], points.T, points[None, None]):
                with self.subTest(name, shape=cloud.shape):
                    self.expect_error(ValueError, "must have the shape", lambda: function(cloud))
            for cloud in (
                points[::-1],
                points[:, ::-1],
                numpy.asfortranarray(points),
                view[:, :7],
                view[::2],
            ):
                with self.subTest(name, shape=cloud.shape, strides=cloud.strides):
                    self.expect_error(ValueError, "ascontiguousarray", lambda: function(cloud))

    def test_nothing_and_next_to_nothing(self):
        for name in ("consolidate", "triangulate"):
            for cloud in (
                numpy.empty((0, 3), numpy.float32),
                numpy.empty((0, 0, 3), numpy.float32),
                numpy.full((9, 3), numpy.nan, numpy.float32),
                numpy.full((9, 3), numpy.inf, numpy.float32),
                points[:1],
            ):
                with self.subTest(name, shape=cloud.shape):
                    self.assertNotEqual(functions[name](cloud).report.remarks, [])
        empty = numpy.empty((0, 3), numpy.float32)
        self.assertEqual(acmap.triangulate(empty).triangles.shape, (0, 3))
        self.assertEqual(acmap.consolidate(empty).points.shape, (0, 3))
        none = numpy.empty((0, 3), numpy.int32)
        self.assertEqual(acmap.vote_normals(empty, none).normals.shape, (0, 3))
        self.assertEqual(acmap.find_planes(empty, empty).patches, [])
        rectified = acmap.rectify([empty], poses)
        self.assertEqual(rectified.report.outcome, "undetermined")
        self.assertEqual(rectified.poses.tolist(), poses.tolist())
        adjusted = acmap.adjust([empty, empty], two_poses)
        self.assertEqual(adjusted.report.outcome, "undetermined")
        self.assertEqual(adjusted.poses.tolist(), two_poses.tolist())

    def test_skipped_points_are_counted(self):
        broken = points.copy()
        broken[::10, 1] = numpy.nan
        self.assertEqual(acmap.triangulate(broken).report.invalid_points, 200)
        self.assertEqual(acmap.consolidate(broken).report.invalid_points, 200)

    def test_settings_out_of_their_range(self):
        for name, settings in (
            ("consolidate", {"voxel_size": -1}),
            ("consolidate", {"sensor_origin": (0, 0, numpy.nan)}),
            ("triangulate", {"maximum_edge_length": numpy.inf}),
            ("triangulate", {"rule": "Paper"}),
            ("vote_normals", {"radius": -0.1}),
            ("vote_normals", {"crease_weight": 0}),
            ("vote_normals", {"corner_weight": numpy.nan}),
            ("find_planes", {"member_distance": 0}),
            ("find_planes", {"normal_angle": 2}),
            ("find_planes", {"plane_distance": 0}),
            ("find_planes", {"least_area": -1}),
            ("rectify", {"bin_size": 0}),
            ("rectify", {"entropy_weight": 0}),
            ("rectify", {"projection_weight": -1}),
            ("rectify", {"odometry_length": 0}),
            ("rectify", {"odometry_turn_per_radian": -1}),
            ("rectify", {"mode": ""}),
            ("adjust", {"odometry_length": 0}),
            ("adjust", {"odometry_turn": numpy.nan}),
        ):
            (key,) = settings
            if key.startswith("odometry"):
                key = "odometry noise"  # one setter takes all four
            with self.subTest(name, **settings):
                self.expect_error(
                    ValueError, f"^{key}.* is refused: ", lambda: functions[name](points, **settings)
                )

    def test_arrays_that_do_not_fit(self):
        few = points[:5]
        ten = numpy.zeros(10, numpy.int32)
        for call in (
            lambda: acmap.triangulate(points, normals=few),
            lambda: acmap.find_planes(points, few),
            lambda: acmap.find_planes(points, acmap.vote_normals(few, few.astype("i4") * 0)),
            lambda: acmap.vote_normals(points, numpy.array([[0, 1, 2000]], numpy.int32)),
            lambda: acmap.vote_normals(points, numpy.array([[0, 1, -1]], numpy.int32)),
            lambda: acmap.vote_normals(points, numpy.zeros((4, 4), numpy.int32)),
            lambda: acmap.consolidate(points, viewpoints=few, view=ten),
            lambda: acmap.consolidate(points, viewpoints=few),
            lambda: acmap.consolidate(points, view=ten),
            lambda: acmap.rectify([points], numpy.zeros((2, 4, 4))),
            lambda: acmap.rectify([points], 2 * poses),
            lambda: acmap.rectify([points], numpy.eye(3)[None]),
            lambda: acmap.rectify([points], poses, normals=[few]),
            lambda: acmap.rectify([points], poses, normals=[]),
            lambda: acmap.rectify([points], poses, weights=[numpy.ones(3, numpy.float32)]),
            lambda: acmap.rectify([points], poses, weights=[points[:, 0] - 9]),
            lambda: acmap.rectify([], numpy.zeros((0, 4, 4))),
            lambda: acmap.adjust([points], two_poses),
            lambda: acmap.adjust([points], 2 * poses),
            lambda: acmap.adjust([points], poses, sigmas=[]),
            lambda: acmap.adjust([points], poses, sigmas=[numpy.ones(3, numpy.float32)]),
            lambda: acmap.adjust([], numpy.zeros((0, 4, 4))),
        ):
            with self.assertRaises(ValueError):
                call()
        for call in (
            lambda: acmap.vote_normals(points, mesh.triangles.astype(numpy.int64)),
            lambda: acmap.consolidate(points, viewpoints=few, view=points[:, 0]),
            lambda: acmap.rectify([points], poses.astype(numpy.float32)),
            lambda: acmap.rectify([points], poses, weights=[ten]),
            lambda: acmap.triangulate(points, maximum_edge=1),
            lambda: acmap.triangulate(points, 0.1),
        ):
            with self.assertRaises(TypeError):
                call()


class Files(unittest.TestCase):
    def test_faults_are_os_errors(self):
        with self.assertRaisesRegex(OSError, "^/none/such.ply: "):
            acmap.read_cloud("/none/such.ply")
        with self.assertRaises(OSError):
            acmap.read_mesh(__file__)
        with self.assertRaises(OSError):
            acmap.write_mesh("/none/such.ply", points, mesh)


class Running(unittest.TestCase):
    big = noisy_wall(300_000)

    def test_too_much_memory(self):
        with self.assertRaisesRegex(MemoryError, "GB"):
            acmap.triangulate(points, memory_limit=1000)

    def test_progress_rises_to_the_end(self):
        for name, function in functions.items():
            told = []
            function(points, progress=lambda *now: told.append(now))
            fractions = [fraction for fraction, step in told]
            with self.subTest(name):
                self.assertGreater(len(told), 1)
                self.assertEqual(fractions, sorted(fractions))
                self.assertTrue(0 <= fractions[0] and fractions[-1] <= 1)
                self.assertTrue(all(step for fraction, step in told))

    def test_false_stops(self):
        for name, function in functions.items():
            with self.subTest(name), self.assertRaisesRegex(acmap.Cancelled, "cancelled"):
                function(points, progress=lambda fraction, step: False)

    def test_errors_of_the_listener_come_out(self):
        def listener(fraction, step):
            raise LookupError(step)

        for name, function in functions.items():
            with self.subTest(name), self.assertRaises(LookupError):
                function(points, progress=listener)
        with self.assertRaises(TypeError):
            acmap.triangulate(points, progress=lambda: True)
        with self.assertRaises(TypeError):
            acmap.triangulate(points, progress=3)

    def test_a_signal_stops_without_a_listener(self):
        def handler(number, frame):
            raise InterruptedError("signal")

        before = signal.signal(signal.SIGALRM, handler)
        try:
            with self.assertRaisesRegex(InterruptedError, "signal"):
                signal.setitimer(signal.ITIMER_REAL, 0.02)
                acmap.triangulate(self.big, threads=1)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)

    def test_other_threads_run_meanwhile(self):
        turns = []
        is_over = threading.Event()

        def count():
            while not is_over.is_set():
                turns.append(1)
                time.sleep(0.001)

        other = threading.Thread(target=count)
        other.start()
        before = len(turns)
        acmap.consolidate(self.big, voxel_size=0.02)
        during = len(turns) - before
        is_over.set()
        other.join()
        self.assertGreater(during, 3)

    def test_calls_from_two_threads(self):
        expected = acmap.triangulate(points).triangles.tobytes()
        found = []
        workers = [
            threading.Thread(
                target=lambda: found.append(acmap.triangulate(points).triangles.tobytes())
            )
            for worker in range(2)
        ]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        self.assertEqual(found, [expected, expected])


if __name__ == "__main__":
    unittest.main()
