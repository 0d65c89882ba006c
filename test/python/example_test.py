"""The example runs, finds what it shows, and draws it where matplotlib is."""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

example = pathlib.Path(os.environ["ACMAP_SHARE"], "examples", "python_room", "room.py")
can_draw = importlib.util.find_spec("matplotlib") is not None


class Example(unittest.TestCase):
    def test_it_finds_what_it_shows(self):
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, "-B", example, *([folder] if can_draw else [])]
            run = subprocess.run(command, capture_output=True, text=True)
            self.assertEqual(run.stderr, "")
            self.assertEqual(run.returncode, 0)
            self.assertRegex(run.stdout, r"planes: (9|10|11), with (99|100)\.\d% of the points")
            textured = re.search(r"map: (\d+) planes, (\d+) textures, ([0-9.]+)%", run.stdout)
            self.assertGreaterEqual(int(textured[1]), 9)
            self.assertGreaterEqual(int(textured[2]), int(textured[1]))
            self.assertGreater(float(textured[3]), 60)
            self.assertIn("rectification: rectified", run.stdout)
            off = re.search(r"([0-9.]+) m off before, ([0-9.]+) m after", run.stdout)
            self.assertGreater(float(off[1]), 1)
            self.assertLess(float(off[2]), 0.4)
            if can_draw:
                self.expect_pictures(pathlib.Path(folder))

    def expect_pictures(self, folder):
        from matplotlib import image

        names = sorted(path.name for path in folder.iterdir())
        self.assertEqual(
            names, ["python_corridor.png", "python_mesh.png", "python_planes.png"]
        )
        for name in names:
            picture = image.imread(folder / name)[..., :3]
            shown = (picture < 0.95).any(axis=2).mean()
            self.assertGreater(shown, 0.02, name)


if __name__ == "__main__":
    unittest.main()
