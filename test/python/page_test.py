"""The programs on the page doc/python.md run as they are printed."""

import os
import pathlib
import re
import tempfile
import unittest

import numpy

from rooms import colors_at, room_view, turned

page = pathlib.Path(os.environ["ACMAP_SHARE"]).parent / "doc" / "python.md"


class Page(unittest.TestCase):
    def test_programs_run(self):
        programs = re.findall(r"^```python\n(.*?)^```", page.read_text(), re.S | re.M)
        self.assertGreater(len(programs), 2)
        views = []
        for pose in (turned(0), turned(0.3, 0.2, 0.1)):
            points = room_view(90, 120, noise=0.01, pose=pose)
            views.append((points, colors_at(points @ pose[:3, :3].T + pose[:3, 3]), pose))
        known = {"views": views}
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                numpy.save("cloud.npy", room_view(120, 160, noise=0.01))
                for program in programs:
                    with self.subTest(program):
                        exec(compile(program, str(page), "exec"), known)
            finally:
                os.chdir(before)


if __name__ == "__main__":
    unittest.main()
