"""What the module returns can be pickled, copied and printed; paths may be paths; functions
tell their parameters."""

import copy
import inspect
import json
import os
import pathlib
import pickle
import re
import tempfile
import types
import unittest

import numpy

import acmap
from rooms import colors_at, room_view, turned

poses = numpy.array([turned(0), turned(0.3, 0.2, 0.1)])


def properties_of(thing):
    if isinstance(thing, types.SimpleNamespace):
        return vars(thing)
    return {
        name: getattr(thing, name)
        for cls in type(thing).__mro__
        for name, member in vars(cls).items()
        if isinstance(member, property)
    }


# Elements that the map of an empty room has not, as in map.json.
furniture = {"id": 0, "axes": numpy.eye(3).tolist(), "center": [1, 2, 3], "size": [0.9, 2.1, 0.1],
             "template": 0, "covariance": numpy.eye(9).tolist(), "saved_bits": 12.5}
elements = {
    "rooms": [{"center": [1, 2, 3], "area": 12.5, "seen_area": 11, "planes": [0], "openings": [0]}],
    "openings": [{"from": [1, 2, 3], "to": [4, 5, 6], "bottom": 0, "top": None, "kind": "door",
                  "planes": [1], "rooms": [0, -1]}],
    "recesses": [furniture | {"wall": 1, "leaf": 2, "reaches_floor": True}],
    "boxes": [furniture | {"faces": [{"kind": "seen", "plane": 0}] + 5 * [{"kind": "free"}]}],
    "cylinders": [{"id": 0, "axis_point": [1, 2, 3], "axis_direction": [0, 0, 1],
                   "axes": [[1, 0, 0], [0, 1, 0]], "radius": 0.1, "extent": [0, 1], "arc": 3,
                   "hollow": False, "covariance": numpy.eye(5).tolist(), "support": 9,
                   "rmse": 0.01, "area": 1, "template": 0, "saved_bits": 1}],
}  # fmt: skip


def furnished(compact):
    with tempfile.TemporaryDirectory() as folder:
        compact.save(folder)
        path = pathlib.Path(folder) / "map.json"
        path.write_text(json.dumps(json.loads(path.read_text()) | elements))
        return acmap.read_map(folder)


class Objects(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        view = room_view(90, 120, noise=0.01)
        found = acmap.consolidate(view, keep_sources=True)
        mesh = acmap.triangulate(found.points, normals=found.normals, compute_wall_depth=True)
        normals = acmap.vote_normals(found.points, mesh, compute_curvatures=True)
        planes = acmap.find_planes(found.points, normals, mesh, source=view)
        mapping = acmap.CompactMapping()
        for pose in poses:
            points = room_view(90, 120, noise=0.01, pose=pose)
            colors = colors_at(points @ pose[:3, :3].T + pose[:3, 3])
            mapping.add_observation(points, colors, pose)
        made = mapping.compute()
        full = furnished(made)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "mesh.ply"
            acmap.write_mesh(path, found.points, mesh)
            files = [acmap.read_cloud(path), acmap.read_mesh(path)]
        topology = made.topology
        cls.points, cls.mesh, cls.normals, cls.mapping = found.points, mesh, normals, mapping
        cls.all = [found, mesh, normals, planes, *files, made, full, topology, made.report]
        cls.all += [acmap.rectify([view], poses[:1]), acmap.adjust([view], poses[:1])]
        cls.all += [topology.edges[0], topology.faces[0], made.planes[0].polygons[0]]
        for parts in ("planes", "charts", "cylinders", "boxes", "recesses", "rooms", "openings"):
            cls.all.append(getattr(full, parts)[0])
        picture = acmap.TexturePicture.__new__(acmap.TexturePicture)
        picture.__setstate__(full.charts[0].__getstate__()[:2])
        cls.all.append(picture)

    def expect_equal(self, one, other):
        self.assertIs(type(one), type(other))
        if isinstance(one, numpy.ndarray):
            self.assertEqual((one.dtype, one.shape), (other.dtype, other.shape))
            self.assertEqual(one.tobytes(), other.tobytes())
        elif isinstance(one, (list, tuple)):
            self.assertEqual(len(one), len(other))
            for mine, yours in zip(one, other):
                self.expect_equal(mine, yours)
        elif type(one).__module__ == "acmap":
            mine, yours = properties_of(one), properties_of(other)
            self.assertEqual(mine.keys(), yours.keys())
            for name in mine:
                with self.subTest(type(one).__name__, field=name):
                    self.expect_equal(mine[name], yours[name])
        elif isinstance(one, float):
            self.assertEqual(numpy.float64(one).tobytes(), numpy.float64(other).tobytes())
        elif isinstance(one, dict):
            self.assertEqual(one.keys(), other.keys())
            self.expect_equal(list(one.values()), list(other.values()))
        else:
            self.assertEqual(one, other)

    def test_pickled_and_copied(self):
        for thing in self.all:
            for copied in (pickle.loads(pickle.dumps(thing)), copy.copy(thing), copy.deepcopy(thing)):
                with self.subTest(type(thing).__name__):
                    self.expect_equal(copied, thing)

    def test_a_copy_is_its_own(self):
        chart = next(thing for thing in self.all if isinstance(thing, acmap.TextureChart))
        copied = copy.deepcopy(chart)
        copied.colors[:] = 1
        self.assertFalse((chart.colors == 1).all())

    def test_copies_go_on_to_the_next_stage(self):
        mesh, normals = pickle.loads(pickle.dumps((self.mesh, self.normals)))
        expected = acmap.find_planes(self.points, self.normals, self.mesh)
        planes = acmap.find_planes(self.points, normals, mesh)
        self.expect_equal(planes.labels, expected.labels)
        self.expect_equal(planes.patches, expected.patches)
        mesh.triangles[:] = 0  # they are those that the next stage reads
        self.assertGreater(acmap.vote_normals(self.points, mesh).report.unknown, 0)

    def test_broken_pickles_are_refused(self):
        mesh = acmap.Mesh.__new__(acmap.Mesh)
        state = self.mesh.__getstate__()
        for broken in ({"triangles": numpy.zeros((2, 2), numpy.int32)},
                       {"wall_depth": numpy.zeros(1, numpy.uint8)}):
            with self.assertRaises(ValueError):
                mesh.__setstate__(state | broken)
        patch = next(thing for thing in self.all if isinstance(thing, acmap.PlanePatch))
        state = patch.__getstate__()
        for broken in (state[1:], (state[1], *state[1:])):
            with self.assertRaisesRegex(ValueError, "another version"):
                acmap.PlanePatch.__new__(acmap.PlanePatch).__setstate__(broken)

    def test_every_class_is_here(self):
        named = {name for name, thing in vars(acmap).items() if inspect.isclass(thing)}
        self.assertEqual(named - {type(thing).__name__ for thing in self.all},
                         {"Cancelled", "CompactMapping"})

    def test_reprs_are_one_line_that_tells_what_matters(self):
        for thing in [*self.all, self.mapping]:
            with self.subTest(type(thing).__name__):
                self.assertRegex(repr(thing), rf"^acmap\.{type(thing).__name__}\([a-z].*\)$")
                self.assertNotIn("\n", repr(thing))
                self.assertLess(len(repr(thing)), 1000)
        made = next(thing for thing in self.all if isinstance(thing, acmap.CompactMap))
        self.assertRegex(repr(made), r"planes=5, area=\d\d\.\d+, charts=\d+.* poses=\(2, 4, 4\) float64.*"
                                     r"report='(kept|rectified|undetermined|refused)'")
        self.assertRegex(repr(made.report), r"^acmap.Report\(outcome='.*, mode='accurate'")
        self.assertRegex(repr(self.mesh), rf"triangles=\({len(self.mesh.triangles)}, 3\) int32")
        self.assertRegex(repr(made.planes[0]), r"coefficients=\[\S+, \S+, \S+, \S+\], support=\d+, rmse=0\.0")
        self.assertEqual(repr(self.mapping), "acmap.CompactMapping(observations=2)")


class Paths(unittest.TestCase):
    def test_a_path_is_as_good_as_a_text(self):
        points = room_view()
        mesh = acmap.triangulate(points)
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for kind in (str, pathlib.Path, os.fsencode):
                path = kind(os.path.join(folder, f"{len(files)}.ply"))
                acmap.write_mesh(path, points, mesh)
                files.append(acmap.read_cloud(path).points.tobytes() + acmap.read_mesh(path).triangles.tobytes())
            self.assertEqual(len(set(files)), 1)
            mapping = acmap.CompactMapping(folder=pathlib.Path(folder) / "poses")
            for pose in poses:
                mapping.add_observation(points, colors_at(points), pose)
            mapping.compute().save(pathlib.Path(folder) / "map")
            self.assertGreater(len(acmap.read_map(pathlib.Path(folder) / "map").planes), 0)
            self.assertTrue((pathlib.Path(folder) / "poses").is_dir())

    def test_anything_else_is_refused(self):
        for call in (acmap.read_cloud, acmap.read_mesh, acmap.read_map):
            for path in (None, 3):
                with self.assertRaisesRegex(TypeError, "must be a str or a path, not"):
                    call(path)


class Signatures(unittest.TestCase):
    def test_inspect_has_parameters_and_defaults(self):
        signature = inspect.signature(acmap.find_planes)
        self.assertEqual(list(signature.parameters)[:4], ["points", "normals", "triangles", "source"])
        self.assertEqual(signature.parameters["sensor_origin"].default, [0, 0, 0])
        self.assertEqual(signature.parameters["noise_driven"].kind, inspect.Parameter.KEYWORD_ONLY)
        self.assertEqual(list(inspect.signature(acmap.CompactMapping().compute).parameters), ["progress"])
        self.assertIn("sensor", inspect.signature(acmap.CompactMapping).parameters)

    def test_no_type_or_name_is_one_of_cpp(self):
        texts = [acmap.__doc__]
        for thing in vars(acmap).values():
            texts.append(inspect.getdoc(thing) or "")
            if inspect.isclass(thing):
                for member in vars(thing).values():
                    member = getattr(member, "fget", member)
                    texts.append(getattr(member, "__doc__", None) or "")
        for text in texts:
            self.assertIsNone(re.search(r"\barg\d|python::|std::|handle\b|v_h", text), text)


if __name__ == "__main__":
    unittest.main()
