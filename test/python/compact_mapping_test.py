"""Coloured views of a simulated room become a map of textured planes, in a folder too."""

import concurrent.futures
import gc
import html
import inspect
import json
import os
import signal
import tempfile
import unittest

import numpy

import acmap
from rooms import colors_at, room_view, turned, walls

poses = numpy.array([turned(0), turned(0.3, 0.2, 0.1), turned(-0.3, -0.1, 0.3)])


def colored_view(pose, height=90, width=120):
    points = room_view(height, width, noise=0.01, pose=pose)
    return points, colors_at(points @ pose[:3, :3].T + pose[:3, 3])


views = [colored_view(pose) for pose in poses]


def mapping_of_room(**settings):
    mapping = acmap.CompactMapping(**settings)
    for (points, colors), pose in zip(views, poses):
        mapping.add_observation(points, colors, pose)
    return mapping


def texel_centres(chart):
    rows, columns = (0.5 + numpy.indices(chart.kinds.shape))[..., None]
    return chart.origin + columns * chart.texel_u + rows * chart.texel_v


class MapTest(unittest.TestCase):
    def expect_equal(self, one, other):
        self.assertEqual(len(one.planes), len(other.planes))
        for mine, yours in zip(one.planes, other.planes):
            self.assertEqual(mine.coefficients.tobytes(), yours.coefficients.tobytes())
            self.assertEqual(mine.support, yours.support)
            for polygon, its in zip(mine.polygons, yours.polygons):
                self.assertEqual(polygon.outer.tobytes(), its.outer.tobytes())
        self.assertEqual(len(one.charts), len(other.charts))
        for mine, yours in zip(one.charts, other.charts):
            self.assertEqual((mine.plane, mine.polygon), (yours.plane, yours.polygon))
            self.assertEqual(mine.origin.tobytes(), yours.origin.tobytes())
            self.assertEqual(mine.colors.tobytes(), yours.colors.tobytes())
            self.assertEqual(mine.kinds.tobytes(), yours.kinds.tobytes())
        for mine, yours in zip(one.rooms, other.rooms, strict=True):
            self.assertEqual(mine.center.tobytes(), yours.center.tobytes())
            self.assertEqual((mine.area, mine.planes), (yours.area, yours.planes))
        self.assertEqual([opening.rooms for opening in one.openings],
                         [opening.rooms for opening in other.openings])
        self.assertEqual(one.observations, other.observations)
        self.assertEqual(one.stamps.tolist(), other.stamps.tolist())
        self.assertTrue(numpy.allclose(one.poses, other.poses, rtol=0, atol=1e-12))


class Room(MapTest):
    @classmethod
    def setUpClass(cls):
        cls.mapping = mapping_of_room(rectify=False, threads=1)
        cls.map = cls.mapping.compute()

    def test_every_wall_is_a_plane(self):
        found = {
            (int(abs(plane.coefficients[:3]).argmax()), round(float(at), 1))
            for plane in self.map.planes
            for at in [plane.center[abs(plane.coefficients[:3]).argmax()]]
        }
        self.assertEqual(found, set(walls))

    def test_primitives_are_not_searched_where_they_are_refused(self):
        found = mapping_of_room(rectify=False, primitives=False).compute()
        self.assertEqual(found.cylinders, [])
        self.assertEqual(found.boxes, [])
        self.assertEqual(found.recesses, [])
        for name in ("cylinders", "boxes", "recesses"):
            self.assertIsNone(getattr(found.report.planes, name), name)

    def test_a_room_of_planes_has_no_cylinders(self):
        found = mapping_of_room(rectify=False, primitives=True).compute()
        self.assertEqual(found.cylinders, [])
        self.assertEqual(found.report.planes.cylinders.cylinders, 0)
        self.assertEqual(found.boxes, [], "seen from inside")
        self.assertEqual(found.report.planes.boxes.boxes, 0)
        self.assertEqual(found.recesses, [])
        self.assertEqual(found.report.planes.recesses.recesses, 0)
        self.assertEqual(len(found.planes), len(self.map.planes))

    def test_poses_are_as_they_were_given(self):
        self.assertEqual(self.map.poses.dtype, numpy.float64)
        self.assertTrue(numpy.allclose(self.map.poses, poses, rtol=0, atol=1e-12))
        self.assertEqual(self.map.stamps.tolist(), [0, 1, 2])
        self.assertEqual(len(self.map.observations), len(self.map.planes))
        for seen_from in self.map.observations:
            self.assertLessEqual(set(seen_from), {0, 1, 2})
            self.assertGreater(len(seen_from), 0)

    def test_textures_have_the_colours_of_the_room(self):
        self.assertGreaterEqual(len(self.map.charts), len(self.map.planes))
        for chart in self.map.charts:
            self.assertEqual(chart.colors.shape, (*chart.kinds.shape, 3))
            self.assertEqual(chart.colors.dtype, numpy.uint8)
            seen = chart.kinds == 1
            self.assertGreater(seen.mean(), 0.3)
            expected = colors_at(texel_centres(chart))
            off = abs(chart.colors.astype(int) - expected.astype(int))[seen]
            self.assertLess(numpy.median(off), 5)
            plane = self.map.planes[chart.plane]
            heights = texel_centres(chart) @ plane.coefficients[:3] + plane.coefficients[3]
            self.assertLess(abs(heights).max(), 1e-3)
            self.assertLess(chart.polygon, len(plane.polygons))

    def test_report_counts(self):
        report = self.map.report
        self.assertIsNone(report.outcome)
        self.assertIsNone(report.rectification)
        self.assertIsNone(report.adjustment)
        self.assertEqual(report.merging.observations, 3)
        self.assertEqual(report.merging.points, 3 * 90 * 120)
        self.assertEqual(report.planes.planes, len(self.map.planes))
        self.assertGreater(report.planes.voxel_size, 0)
        self.assertEqual(report.texture.charts, len(self.map.charts))
        self.assertTrue(0.003 <= report.texture.texel_size <= 0.03)
        self.assertGreater(report.texture.seen, report.texture.texels / 2)
        steps = [step for step, seconds in report.seconds]
        self.assertEqual(steps, ["merging", "planes", "texture"])
        self.assertIsInstance(report.remarks, list)
        for word in ("outcome=None", "merging=", "planes=", "texture=", "seconds="):
            self.assertIn(word, str(report))

    def test_a_later_run_goes_on_from_the_poses_in_a_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            first, second = (mapping_of_room(folder=folder).compute() for run in range(2))
        self.assertIsNotNone(first.report.rectification)
        self.assertIsNone(second.report.rectification)
        self.assertIn("poses of an earlier run", " ".join(second.report.remarks))
        self.expect_equal(first, second)

    def test_threads_do_not_matter(self):
        self.expect_equal(mapping_of_room(rectify=False, threads=2).compute(), self.map)

    def test_a_mapping_computes_in_two_threads_at_once(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            runs = [pool.submit(self.mapping.compute) for run in range(2)]
        for run in runs:
            self.expect_equal(run.result(), self.map)

    def test_arrays_outlive_their_map(self):
        computed = self.mapping.compute()
        arrays = [computed.poses, computed.stamps, computed.planes[0].coefficients]
        arrays += [computed.charts[0].colors, computed.charts[0].kinds]
        copies = [array.copy() for array in arrays]
        del computed
        gc.collect()
        rubbish = [numpy.full(array.nbytes, 0xAA, numpy.uint8) for array in arrays]
        self.assertEqual(len(rubbish), len(arrays))
        for array, copy in zip(arrays, copies):
            self.assertEqual(array.tobytes(), copy.tobytes())

    def test_saved_and_read_again(self):
        with tempfile.TemporaryDirectory() as parent:
            folder = os.path.join(parent, "map")
            names = self.map.save(folder, color_tolerance=0)
            self.assertEqual(sorted(names), sorted(os.listdir(folder)))
            for name in ("map.json", "map.obj", "map.glb", "texture_0.png"):
                self.assertIn(name, names)
            read = acmap.read_map(folder)
        self.expect_equal(read, self.map)
        self.assertIsNone(read.report)

    def test_a_notebook_shows_its_page(self):
        shown = self.map._repr_html_()
        self.assertNotIn("<script", shown.split("srcdoc=")[0])
        if shown.startswith("<iframe"):
            page = html.unescape(shown.split('srcdoc="')[1].split('"')[0])
            self.assertTrue(page.startswith("<!DOCTYPE html>"))
            self.assertIn("Dollhouse", page)
        else:
            self.assertIn("<svg", shown, "the plan, where acmap has no page")

    def test_the_shift_of_coordinates_is_saved(self):
        self.assertEqual(self.map.shift.dtype, numpy.float64)
        self.assertEqual(self.map.shift.tolist(), [0, 0, 0])
        with tempfile.TemporaryDirectory() as folder:
            self.map.save(folder)
            read = acmap.read_map(folder)
            read.shift[:] = 452000, -5849000, 0
            read.save(folder)
            again = acmap.read_map(folder)
        self.assertEqual(again.shift.tolist(), [452000, -5849000, 0])
        self.assertEqual(self.map.shift.tolist(), [0, 0, 0])

    def test_topology_has_the_points_of_the_polygons_once(self):
        topology = self.map.topology
        self.assertEqual(topology.vertices.dtype, numpy.float32)
        self.assertEqual(len(numpy.unique(topology.vertices, axis=0)), len(topology.vertices))
        for face in topology.faces:
            polygon = self.map.planes[face.plane].polygons[face.polygon]
            for loop, points in zip([face.outer] + face.holes, [polygon.outer] + polygon.holes,
                                    strict=True):
                self.assertEqual(topology.vertices[loop].tolist(), points.tolist())
        edges = {tuple(edge.vertices): edge for edge in topology.edges}
        for face in topology.faces:
            for pair in zip(face.outer, face.outer[1:] + face.outer[:1]):
                self.assertIn(face.plane, edges[tuple(sorted(pair))].planes)
        kinds = {edge.kind for edge in topology.edges}
        self.assertLessEqual(kinds, {"open", "crease", "contact", "rim", "frontier", "arc"})

    def test_rooms_and_openings_of_a_file(self):
        rooms = [{"center": [1, 2, 3], "area": 12.5, "seen_area": 11, "planes": [0, 1],
                  "openings": [0]}]
        openings = [{"from": [1, 2, 3], "to": [4, 5, 6], "bottom": 0, "top": None,
                     "kind": "door", "planes": [1], "rooms": [0, -1]}]
        with tempfile.TemporaryDirectory() as folder:
            self.map.save(folder)
            path = os.path.join(folder, "map.json")
            with open(path) as file:
                content = json.load(file)
            with open(path, "w") as file:
                json.dump(content | {"rooms": rooms, "openings": openings}, file)
            read = acmap.read_map(folder)
        room, opening = read.rooms[0], read.openings[0]
        self.assertEqual(room.center.tolist(), [1, 2, 3])
        self.assertEqual((room.area, room.seen_area), (12.5, 11))
        self.assertEqual((room.planes, room.openings), ([0, 1], [0]))
        self.assertEqual((opening.start.tolist(), opening.end.tolist()), ([1, 2, 3], [4, 5, 6]))
        self.assertEqual((opening.kind, opening.bottom), ("door", 0))
        self.assertTrue(numpy.isnan(opening.top))
        self.assertEqual((opening.planes, opening.rooms), ([1, -1], [0, -1]))

    def test_recesses_of_a_file(self):
        recess = {"id": 0, "center": [1, 2, 3], "axes": [[0, 0, 1], [0, -1, 0], [1, 0, 0]],
                  "size": [0.9, 2.1, 0.1], "wall": 1, "leaf": 2, "reaches_floor": True,
                  "template": 0, "covariance": numpy.eye(9).tolist(), "saved_bits": 12.5}
        with tempfile.TemporaryDirectory() as folder:
            self.map.save(folder)
            path = os.path.join(folder, "map.json")
            with open(path) as file:
                content = json.load(file)
            with open(path, "w") as file:
                json.dump(content | {"recesses": [recess]}, file)
            [read] = acmap.read_map(folder).recesses
        self.assertEqual(read.center.tolist(), recess["center"])
        self.assertEqual(read.axes.tolist(), recess["axes"])
        self.assertEqual(read.size.tolist(), recess["size"])
        self.assertEqual(read.covariance.tolist(), recess["covariance"])
        self.assertEqual((read.wall, read.leaf, read.reaches_floor), (1, 2, True))
        self.assertEqual((read.template_id, read.saved_bits), (0, 12.5))

    def test_what_is_painted_in_python_is_saved(self):
        computed = self.mapping.compute()
        chart = computed.charts[0]
        chart.colors[chart.kinds == 1] = (1, 2, 3)
        with tempfile.TemporaryDirectory() as folder:
            computed.save(folder)
            read = acmap.read_map(folder).charts[0]
        self.assertTrue((read.colors[read.kinds == 1] == (1, 2, 3)).all())


class Settings(MapTest):
    def test_rectification_is_the_default(self):
        report = mapping_of_room().compute().report
        self.assertIn(report.outcome, ("rectified", "kept", "refused", "undetermined"))
        self.assertEqual(report.rectification.observations, 3)
        self.assertEqual(report.rectification.outcome, report.outcome)
        self.assertIn(f"outcome='{report.outcome}'", str(report))
        self.assertEqual(report.levelling.up.shape, (3,))
        self.assertEqual(report.rectification.moved.shape, (3,))
        self.assertIsNone(report.odometry)

    def test_poses_are_adjusted_in_six_degrees_of_freedom(self):
        lifted = [colored_view(pose, 240, 320) for pose in poses]
        raised = poses + 0.04 * numpy.arange(3)[:, None, None] * (
            numpy.arange(16).reshape(4, 4) == 7)
        made = {}
        for adjust in (False, True):
            mapping = acmap.CompactMapping(rectify=False, adjust=adjust)
            for (points, colors), pose in zip(lifted, raised):
                mapping.add_observation(points, colors, pose)
            made[adjust] = mapping.compute()
        self.assertIsNone(made[False].report.adjustment)
        self.assertAlmostEqual(made[False].poses[2, 1, 3], 0.08)
        self.assertEqual(made[True].report.adjustment.outcome, "adjusted")
        self.assertEqual(len(made[True].report.adjustment.moved), 3)
        self.assertLess(abs(made[True].poses[:, 1, 3]).max(), 0.01)
        self.assertIn("adjustment", [step for step, _ in made[True].report.seconds])

    def test_sizes(self):
        made = mapping_of_room(
            rectify=False, voxel_size=0.1, min_area=7, texel_size=0.05, regular=True
        ).compute()
        self.assertEqual(made.report.planes.voxel_size, 0.1)
        self.assertEqual(made.report.texture.texel_size, 0.05)
        self.assertLess(len(made.planes), 5)
        self.assertGreater(min(plane.area for plane in made.planes), 6.9)
        automatic = mapping_of_room(rectify=False, voxel_size=0, sensor="tof").compute()
        self.assertEqual(len(automatic.planes), 5)

    def test_sensors_that_have_a_picture(self):
        made = mapping_of_room(rectify=False, sensor="stereo").compute()
        self.assertEqual(made.report.merging.refined, 3)
        self.assertGreaterEqual(len(made.planes), 3)
        single = acmap.CompactMapping(sensor="stereo")
        single.add_observation(*views[0])
        self.assertGreaterEqual(len(single.compute().planes), 3)

    def test_the_papers_way(self):
        usual = mapping_of_room(rectify=False).compute()
        self.assertEqual(usual.report.mode, "accurate")
        self.assertGreater(usual.report.planes.consolidated_points, 0)
        paper = mapping_of_room(paper=True).compute()
        self.assertEqual(paper.report.mode, "paper")
        self.assertEqual(paper.report.planes.consolidated_points, 0)
        self.assertGreater(paper.report.rectification.votes, 0)
        self.assertGreater(len(paper.planes), len(usual.planes), "walls come in pieces")
        for departure in ({"sensor": "stereo"}, {"voxel_size": 0.1}, {"min_area": 1}, {"regular": True},
                          {"adjust": True}):
            with self.subTest(departure), self.assertRaisesRegex(ValueError, "departs from the paper"):
                acmap.CompactMapping(paper=True, **departure)

    def test_settings_out_of_their_range(self):
        for key, value in (
            ("sensor", "kinect"),
            ("voxel_size", -0.1),
            ("min_area", numpy.nan),
            ("texel_size", 20),
        ):
            with self.subTest(key), self.assertRaisesRegex(ValueError, f"^{key}.* is refused: "):
                acmap.CompactMapping(**{key: value})
        with self.assertRaises(TypeError):
            acmap.CompactMapping(False)
        with self.assertRaises(TypeError):
            acmap.CompactMapping(voxels=1)

    def test_help_tells_units_and_shapes(self):
        self.assertIn("metres", inspect.getdoc(acmap.CompactMapping))
        text = inspect.getdoc(acmap.CompactMapping.add_observation)
        for word in ("float32", "uint8", "float64", "T_map_camera", "metres"):
            self.assertIn(word, text)
        self.assertIn("Returns", inspect.getdoc(acmap.CompactMapping.compute))


class Observations(MapTest):
    def test_arrays_are_copied_from_any_layout(self):
        mapping = acmap.CompactMapping(rectify=False)
        wide = numpy.full((90, 130, 4), 1e6, numpy.float32)
        wide[:, :120, :3] = views[0][0]
        colors = numpy.asfortranarray(views[0][1])
        mapping.add_observation(wide[:, :120, :3], colors, numpy.asfortranarray(poses[0]))
        wide[:] = 0
        colors[:] = 0
        expected = acmap.CompactMapping(rectify=False)
        expected.add_observation(*views[0], poses[0])
        self.expect_equal(mapping.compute(), expected.compute())

    def test_a_view_without_a_pose_is_the_frame_of_the_map(self):
        mapping = acmap.CompactMapping()
        mapping.add_observation(*views[0])
        made = mapping.compute()
        self.assertGreaterEqual(len(made.planes), 3)
        self.assertEqual(made.poses.tolist(), [numpy.eye(4).tolist()])

    def test_poses_are_given_for_all_or_for_none(self):
        mapping = acmap.CompactMapping()
        with self.assertRaisesRegex(ValueError, "no observation"):
            mapping.compute()
        mapping.add_observation(*views[0], poses[0])
        mapping.add_observation(*views[1], pose=None)
        with self.assertRaisesRegex(ValueError, "1 of 2 observations have poses"):
            mapping.compute()

    def test_views_that_show_nothing_find_no_pose(self):
        mapping = acmap.CompactMapping()
        for points, colors in views[:2]:
            mapping.add_observation(points, numpy.full_like(colors, 90))
        with self.assertRaisesRegex(ValueError, "could be joined"):
            mapping.compute()

    def test_what_does_not_fit_is_named(self):
        points, colors = views[0]
        pose = poses[0]
        stretched = pose.copy()
        stretched[0, 0] = 2
        for error, text, arguments in (
            (TypeError, "^points: .*float32", (points.astype(float), colors)),
            (TypeError, "^points: .*numpy", (points.tolist(), colors)),
            (TypeError, "^points: .*numpy", (None, colors)),
            (TypeError, "^colors: .*uint8", (points, colors.astype(numpy.float32))),
            (TypeError, "^colors: .*uint8", (points, colors.astype(numpy.int8))),
            (TypeError, "^pose: .*float64", (points, colors, pose.astype(numpy.float32))),
            (TypeError, "^pose: .*numpy", (points, colors, pose.tolist())),
            (ValueError, r"^points: .*\(h, w, 3\)", (points.reshape(-1, 3), colors)),
            (ValueError, r"^points: .*\(h, w, 3\)", (points[..., :2], colors)),
            (ValueError, "^points: .*rows", (points[:1], colors[:1])),
            (ValueError, "^points: .*rows", (points[:, :0], colors[:, :0])),
            (ValueError, r"^colors: .*\(90, 120, 3\)", (points, colors[:-1])),
            (ValueError, r"^colors: .*\(h, w, 3\)", (points, colors[..., 0])),
            (ValueError, r"^pose: .*\(4, 4\)", (points, colors, pose[:3])),
            (ValueError, r"^pose: .*\(4, 4\)", (points, colors, poses)),
            (ValueError, "^pose: .*0 0 0 1", (points, colors, 2 * pose)),
            (ValueError, "^pose: .*rigid", (points, colors, stretched)),
            (ValueError, "^pose: ", (points, colors, pose * numpy.nan)),
        ):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                acmap.CompactMapping().add_observation(*arguments)

    def test_the_conversion_that_is_named_keeps_colours_bright(self):
        points, colors = views[0]
        gaps = (colors / 255).astype(numpy.float32)
        gaps[0, 0] = numpy.nan
        for name, given in (
            ("0 to 1", colors / 255),
            ("0 to 1 with NaN", gaps),
            ("0 to 255", colors.astype(numpy.float32)),
            ("integers", colors.astype(numpy.int64)),
            ("16 bits", colors.astype(numpy.uint16) * 257),
            ("black", numpy.zeros(colors.shape)),
            ("bool", colors > 128),
        ):
            with self.subTest(name), numpy.errstate(invalid="ignore"):
                with self.assertRaisesRegex(TypeError, "^colors: .* is refused") as refused:
                    acmap.CompactMapping().add_observation(points, given)
                advice = str(refused.exception).split("pass ")[1]
                converted = eval(advice, {"numpy": numpy, "colors": given})
                self.assertEqual(converted.dtype, numpy.uint8)
                acmap.CompactMapping().add_observation(points, converted)
                if name == "bool":
                    self.assertEqual(converted.max(), 255)
                elif name != "black":
                    off = abs(converted.astype(int) - colors)[1:]
                    largest = 30 if name == "16 bits" else 1
                    self.assertLessEqual(off.max(), largest)

    def test_the_up_direction_can_be_stated(self):
        made = mapping_of_room(up=(0, -1, 0)).compute()
        self.assertTrue(numpy.allclose(made.up, (0, -1, 0), atol=1e-6))
        self.assertTrue(made.report.levelling.found)
        with self.assertRaisesRegex(ValueError, "^up: "):
            acmap.CompactMapping(up=(0, 0, 0))

    def test_a_refused_observation_is_not_added(self):
        mapping = acmap.CompactMapping()
        with self.assertRaises(ValueError):
            mapping.add_observation(*views[0], 2 * poses[0])
        with self.assertRaisesRegex(ValueError, "no observation"):
            mapping.compute()


class Files(unittest.TestCase):
    def test_faults_are_os_errors(self):
        with self.assertRaises(OSError):
            acmap.read_map(os.path.join(__file__, "map"))
        mapping = acmap.CompactMapping()
        mapping.add_observation(*views[0])
        with self.assertRaises(OSError):
            mapping.compute().save(os.path.join(__file__, "map"))


class Progress(unittest.TestCase):
    def test_it_rises_to_the_end(self):
        told = []
        mapping_of_room().compute(progress=lambda *now: told.append(now))
        fractions = [fraction for fraction, step in told]
        self.assertGreater(len(told), 5)
        self.assertEqual(fractions, sorted(fractions))
        self.assertTrue(0 <= fractions[0] and 0.8 < fractions[-1] <= 1)
        self.assertTrue(all(step for fraction, step in told))

    def test_false_stops(self):
        mapping = mapping_of_room(rectify=False)
        for end in (0, 0.55, 0.7, 0.85):
            with self.subTest(end), self.assertRaisesRegex(acmap.Cancelled, "cancelled"):
                mapping.compute(lambda fraction, step: fraction < end)
        self.assertGreaterEqual(len(mapping.compute().planes), 3)

    def test_errors_of_the_listener_come_out(self):
        def listener(fraction, step):
            raise LookupError(step)

        with self.assertRaises(LookupError):
            mapping_of_room().compute(listener)
        with self.assertRaises(TypeError):
            mapping_of_room().compute(progress=3)

    def test_a_signal_stops_without_a_listener(self):
        def handler(number, frame):
            raise InterruptedError("signal")

        mapping = mapping_of_room(threads=1)
        before = signal.signal(signal.SIGALRM, handler)
        try:
            with self.assertRaisesRegex(InterruptedError, "signal"):
                signal.setitimer(signal.ITIMER_REAL, 0.02)
                mapping.compute()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)


if __name__ == "__main__":
    unittest.main()
