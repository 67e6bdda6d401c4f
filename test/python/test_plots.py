#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Programs that plot draw what they are given, and name what they cannot read.

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
sys.path.insert(0, str(ROOT / "python"))
import plot_results  # noqa: E402

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

    def test_growth_of_the_belief(self):
        table = self.folder / "growth.csv"
        table.write_text("contacts,free_poses,free_pose_s,update_s,memory_mb\n"
                         "20,900,1e-4,0.4,40\n40,2000,2e-4,0.8,80\n")
        picture = self.folder / "growth.png"
        result = run("plot_growth.py", "--output", picture, f"in space={table}")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.expect_picture(picture)
        self.assertIn("NAME=TABLE", run("plot_growth.py", "--output", picture, table).stderr)

    def test_table_of_an_ablation(self):
        for name, collisions, reached in (("nothing", 8.0, True), ("extents", 40.0, False)):
            (self.folder / name).mkdir()
            content = {"scenario": "scene", "trials": [{"success": reached}, {"success": True}],
                       "summary": {"collisions": {"mean": collisions}}}
            (self.folder / name / "smore_scene.json").write_text(json.dumps(content))
            (self.folder / name / "smore_of_another_call.json").write_text(json.dumps({**content, "scenario": "other"}))
        folders = [self.folder / "nothing", self.folder / "extents"]
        result = run("table_of_ablation.py", *folders, "--", "smore_scene.json")
        self.assertEqual(result.stdout.splitlines(), [
            "| without | scene |", "|---|---|", "| nothing | 8.0 |", "| extents | 40.0 (1 of 2) |"])

    def test_an_ablation_whose_trials_all_broke_off_has_a_dash(self):
        content = {"scenario": "scene", "trials": [{"success": False}], "summary": {"collisions": {"mean": None}}}
        (self.folder / "smore_copy.json").write_text(json.dumps(content))
        result = run("table_of_ablation.py", self.folder, "--", "smore_copy.json")
        self.assertEqual(result.stdout.splitlines()[::2], ["| without | copy |", f"| {self.folder.name} | - (0 of 1) |"])

    def test_results_of_other_parameters_are_not_put_together(self):
        files = []
        for name, parameters in (("plain", {}), ("again", {}), ("bold", {"belief": {"radius": 0.3}})):
            files.append(self.folder / f"{name}.json")
            trials = [{"success": True, "collisions": 3}]
            files[-1].write_text(json.dumps(
                {"scenario": "scene", "method": "smore", "parameters": parameters, "trials": trials}))
        self.assertEqual(list(plot_results.read(files[:2])[0]), ["smore"])
        trials = plot_results.read(files)[0]
        self.assertEqual({name: len(some) for name, some in trials.items()}, {"smore (bold)": 1, "smore (plain)": 2})
        for name in ("one", "other"):
            (self.folder / name).mkdir()
        alike = [shutil.copy(file, self.folder / name / "smore.json") for file, name in zip(files[1:], ("one", "other"))]
        self.assertEqual(list(plot_results.read(alike)[0]), ["smore (one/smore)", "smore (other/smore)"])
        self.assertEqual(run("plot_results.py", *files, "--output", self.folder / "boxes.png").returncode, 0)

    def test_reliability_of_motions(self):
        # In each bin as many motions touch as their risk says, but for the last, where none does.
        sure = [{"risk": 0.0, "touched": False}] * 10
        even = [{"risk": 0.5, "touched": i % 2 == 0} for i in range(20)]
        wrong = [{"risk": 1.0, "touched": False}] * 10
        files = []
        for name, motions in (("calibrated", sure + even), ("wrong", wrong)):
            files.append(self.folder / f"{name}.json")
            content = {"scenario": "scene", "method": "smore", "trials": [{"motions": motions}]}
            files[-1].write_text(json.dumps(content))
        picture = self.folder / "reliability.png"
        result = run("plot_reliability.py", files[0], "--output", picture)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("30 motions", result.stdout)
        self.assertIn("calibration error 0.000", result.stdout)
        self.expect_picture(picture)
        result = run("plot_reliability.py", *files, "--output", picture)
        self.assertIn("calibration error 0.250", result.stdout)

    def test_results_without_motions_are_an_error(self):
        other = self.folder / "empty.json"
        other.write_text('{"scenario": "scene", "method": "smore", "trials": []}')
        result = run("plot_reliability.py", other, "--output", self.folder / "no.png")
        self.assertEqual(result.returncode, 1)
        self.assertNotIn("Traceback", result.stderr)

    def test_a_file_that_is_no_result_is_an_error(self):
        other = self.folder / "other.json"
        for content in ("{}", "name: scene"):
            other.write_text(content)
            for program in ("plot_results.py", "plot_reliability.py"):
                result = run(program, other, "--output", self.folder / "no.png")
                self.assertEqual(result.returncode, 1)
                self.assertIn("other.json: no result of smore_experiment", result.stderr)
                self.assertNotIn("Traceback", result.stderr)
            self.assertIn("no result of", run("table_of_results.py", other).stderr)

    def test_a_name_that_is_no_pictures_is_an_error(self):
        good = self.folder / "good.json"
        trials = [{"success": True, "collisions": 3}]
        good.write_text(json.dumps({"scenario": "scene", "method": "smore", "trials": trials}))
        for name, words in (("good.yaml", "no kind of picture"), ("none/good.png", "cannot be written")):
            result = run("plot_results.py", good, "--output", self.folder / name)
            self.assertEqual(result.returncode, 1)
            self.assertIn(words, result.stderr)
            self.assertNotIn("Traceback", result.stderr)


if __name__ == "__main__":
    unittest.main()
