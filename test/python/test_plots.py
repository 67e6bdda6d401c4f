#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Both plotting programs draw what they are given, and name what they cannot read.

    test_plots.py PROGRAM_THAT_WRITES_TREES
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import matplotlib.image

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENARIO = ROOT / "config/scenarios/s_shape_two_pegs.yaml"
WRITER = sys.argv.pop()


def run(program, *arguments):
    command = ["/usr/bin/python3", ROOT / "python" / program, *arguments]
    return subprocess.run(command, capture_output=True, text=True)


class PlotsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        subprocess.run([WRITER, str(cls.folder)], check=True)
        shutil.copy(cls.folder / "scattered.ot", cls.folder / "world.ot")
        shutil.copy(cls.folder / "pruned.ot", cls.folder / "object.ot")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def expect_picture(self, file):
        colors = {tuple(pixel) for row in matplotlib.image.imread(file)[::7, ::7] for pixel in row}
        self.assertGreater(len(colors), 20)

    def test_maps_of_planar_and_spatial_scenes(self):
        spatial = self.folder / "spatial.yaml"
        spatial.write_text(SCENARIO.read_text().replace("motion: planar", "motion: spatial"))
        path = self.folder / "summary.json"
        path.write_text(json.dumps({"path": [[0, 0, 0, 0, 0, 0, 1], [-1, 0.1, 0, 0, 0, 0, 1]]}))
        for scenario in (SCENARIO, spatial):
            picture = self.folder / f"{scenario.stem}.png"
            result = run("plot_maps.py", "--scenario", scenario, "--maps", self.folder,
                         "--path", path, "--output", picture)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.expect_picture(picture)

    def test_missing_maps_are_named(self):
        result = run("plot_maps.py", "--scenario", SCENARIO, "--maps", self.folder / "none")
        self.assertEqual(result.returncode, 1)
        self.assertIn("none/world.ot", result.stderr)
        self.assertNotIn("Traceback", result.stderr)

    def test_results_of_methods(self):
        files = []
        for method, collisions in (("smore", [9, 0, 12]), ("paper", [80])):
            trials = [{"success": count > 0, "collisions": count} for count in collisions]
            files.append(self.folder / f"{method}.json")
            content = {"scenario": "scene", "method": method, "trials": trials}
            files[-1].write_text(json.dumps(content))
        picture = self.folder / "results.png"
        result = run("plot_results.py", *files, "--output", picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.expect_picture(picture)

    def test_a_file_that_is_no_result_is_an_error(self):
        other = self.folder / "other.json"
        other.write_text("{}")
        result = run("plot_results.py", other, "--output", self.folder / "no.png")
        self.assertEqual(result.returncode, 1)
        self.assertNotIn("Traceback", result.stderr)


if __name__ == "__main__":
    unittest.main()
