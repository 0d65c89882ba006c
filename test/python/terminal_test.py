"""What a tool shows on a terminal: one bar that never stands still, its stages, what to open."""

import os
import re
import tempfile
import unittest

import numpy

from on_terminal import shown_by
from rooms import room_view

tool = os.path.join(os.environ["ACMAP_BIN"], "pcl_compact_mapping")


class Terminal(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.cloud = os.path.join(cls.folder.name, "room.xyz")
        numpy.savetxt(cls.cloud, room_view(720, 960, noise=0.005).reshape(-1, 3), "%.4f")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def map(self, **environment):
        output = tempfile.mkdtemp(prefix="map of ", dir=self.folder.name)
        cache = os.path.join(self.folder.name, "cache")
        code, _, parts = shown_by(
            [tool, self.cloud, "-o", output, "--no-pictures"],
            dict(os.environ, COLUMNS="80", TERM="xterm", XDG_CACHE_HOME=cache, **environment),
        )
        text = "".join(part for _, part in parts)
        self.assertEqual(code, 0, text)
        return output, parts, text

    def test_one_bar_that_does_not_fall_or_stand_still(self):
        _, parts, text = self.map()
        shares = [int(share) for share in re.findall(r"\] (\d+) % ", text)]
        self.assertEqual(shares, sorted(shares))
        self.assertGreater(len(set(shares)), 1)
        bars = [at for at, part in parts if "] " in part and " % " in part]
        self.assertLess(max(numpy.diff(bars), default=0), 2)

    def test_each_line_of_the_bar_fits(self):
        for line in re.split("[\r\n]+", self.map()[2]):
            if line.startswith("["):
                self.assertLess(len(line.replace("\x1b[K", "")), 80, line)

    def test_finished_stages_have_their_seconds(self):
        text = re.sub("\x1b\\[[0-9]*[mK]", "", self.map()[2])
        stages = re.findall(r"(?:^|[\r\n])(\w+): +[0-9.e-]+ s\r", text)
        self.assertEqual(stages, ["cloud", "planes", "texture", "map"])

    def test_the_second_run_knows_the_time_from_the_start_on(self):
        self.map()
        _, parts, text = self.map()
        first = next(part for _, part in parts if " % " in part)
        self.assertIn(" s left", first)

    def test_the_last_screen_names_what_to_open(self):
        output, _, text = self.map()
        last = text.splitlines()[-10:]
        self.assertIn(output + "/report.html", last[-1])
        for line in last:
            self.assertRegex(line, r"^(\x1b\[1m)?[a-z ]+:", "ten lines of the summary")

    def test_no_colour_where_none_is_wanted(self):
        self.assertIn("\x1b[1m", self.map()[2])
        self.assertNotIn("\x1b[1m", self.map(NO_COLOR="1")[2])

    def test_links_where_the_terminal_knows_them(self):
        output, _, text = self.map(VTE_VERSION="7000")
        address = "file://" + output.replace(" ", "%20") + "/report.html"
        self.assertIn("\x1b]8;;" + address + "\x1b\\" + output, text)


if __name__ == "__main__":
    unittest.main()
