"""The type stubs tell what the module has, and the programs of users pass with them."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

here = pathlib.Path(__file__).parent


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
class Types(unittest.TestCase):
    def run_module(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, "-B", "-m", *arguments]
            environment = os.environ | {"MYPY_CACHE_DIR": folder}
            return subprocess.run(
                command, capture_output=True, text=True, cwd=folder, env=environment
            )

    def check(self, program):
        return self.run_module("mypy", "--strict", program)

    def test_stubs_are_those_of_the_module(self):
        run = self.run_module("mypy.stubtest", "acmap")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_a_program_with_types_passes(self):
        run = self.check(here / "typed_program.py")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_wrong_types_are_found(self):
        run = self.check(here / "wrong_types.py")
        wrong = [line.split(":")[1] for line in run.stdout.splitlines() if ": error: " in line]
        expected = [
            str(number)
            for number, line in enumerate((here / "wrong_types.py").read_text().splitlines(), 1)
            if line.endswith("# wrong")
        ]
        self.assertEqual(wrong, expected, run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main()
