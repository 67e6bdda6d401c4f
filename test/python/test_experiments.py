#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Experiments lose no finished trial, repeat none, and draw what they have found.

    test_experiments.py
"""
import json
import pathlib
import sys
import tempfile
import unittest

import matplotlib.animation
import matplotlib.figure
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
from experiments import (  # noqa: E402
    animation, calibration, choices, figure3, figure4, figure5, figure6, figure7, figure8, figure9, figure10,
    generality, learning, lines_through_a_voxel, methods, replays, rivals, sensitivity, sweep, trials,
)
from scene_geometry import rotation_of  # noqa: E402
from experiments.recording import FREE, Recording, moments  # noqa: E402
from experiments.trials import Store, Trial, TrialError, run  # noqa: E402

# Stands for smore_experiment: notes each call, and fails for seed 13.
PROGRAM = """#!/usr/bin/python3
import json, sys
arguments = dict(zip(sys.argv[1:], sys.argv[2:] + [""]))
open(sys.argv[0] + ".calls", "a").write(arguments["--seed"] + "\\n")
if arguments["--seed"] == "13":
    sys.exit("no thirteenth trial")
if arguments["--seed"] == "11":
    open(arguments["--output"], "w").write(json.dumps({"trials": [{"broken": True, "reason": "the eleventh broke"}]}))
    sys.exit("1 of 1 trials broke off; their reasons stand in the results")
seed = int(arguments["--seed"])
motions = [{"risk": 0.9, "touched": True}] * (seed % 5) + [{"risk": 0.4, "touched": False}]
trial = {"seed": seed, "success": seed % 7 != 0, "collisions": seed % 5, "motions": motions}
trial.update({"interactions": 100 * seed, "episodes": [[50, 1, -9.0], [100 * seed, 2, -3.0]], "reason": "at the goal"})
some_map = {"precision": None if seed == 1001 else 0.5, "occupied": seed % 3}
trial.update({side: some_map for side in ("object_map", "world_map")})
open(arguments["--output"], "w").write(json.dumps({"trials": [trial]}))
if "--record" in arguments:
    import pathlib
    folder = pathlib.Path(arguments["--record"])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / ("seed_%d.evidence" % seed)).write_text(pathlib.Path(sys.argv[0]).with_suffix(".evidence").read_text())
"""

# Stands for smore_rebuild: keeps what it was given, and writes two octrees of one leaf, whose probability is a half.
REBUILD = """#!/usr/bin/python3
import pathlib, struct, sys
output = pathlib.Path(sys.argv[sys.argv.index("--output") + 1])
output.mkdir(exist_ok=True)
header = b"# Octomap OcTree file\\nid OcTree\\nsize 1\\nres 0.03\\ndata\\n"
for side in ("world", "object"):
    (output / (side + ".ot")).write_bytes(header + struct.pack("<fB", 0.0, 0))
given = pathlib.Path(sys.argv[sys.argv.index("--evidence") + 1]).read_text()
(output / "summary.json").write_text(given)
"""

# Stands for smore_score: one group of scores, with voxels in two bins.
SCORE = """#!/usr/bin/python3
import json, sys
bins = [{"stated": 0.2, "true": 0.1, "count": 300}, {"stated": 0.9, "true": 1.0, "count": 3}]
voxels = {"bins": bins, "calibration_error": 0.1, "largest_error": None, "voxels": 303}
group = {"world_voxels": voxels, "object_voxels": voxels}
open(sys.argv[sys.argv.index("--output") + 1], "w").write(json.dumps({"groups": [group]}))
"""


def row_major(x, turn=0.0):
    cosine, sine = np.cos(turn), np.sin(turn)
    return [cosine, -sine, 0, x, sine, cosine, 0, 0, 0, 0, 1, 0]


def evidence_of_two_motions():
    """The first touches and is set back, the second arrives."""
    records = [{"record": name} for name in ("task", "method")]
    for contact, end in ((1, "contact"), (0, "reached")):
        records.append({"record": "motion", "path": [row_major(0), row_major(-1)]})
        for sample in range(60):
            records.append({"record": "observation", "state": "free", "pose": row_major(-0.002 * sample)})
        if contact:
            line = {"point": [0.1, 0, 0], "direction": [0, 1, 0]}
            turned = row_major(-0.12, np.pi / 2)
            records.append({"record": "observation", "state": "contact", "pose": turned})
            records.append({"record": "truth", "contact": 1, "points": [{"position": [0, 0.15, 0]}]})
        records.append({"record": "motion_end", "end": end, "pose": row_major(-0.12 if contact else -1)})
        if contact:
            records.append({"record": "observation", "state": "contact", "pose": turned, "line": line})
            records.append({"record": "observation", "state": "free", "pose": row_major(0)})
    lines = [{"format": "smore evidence"}, *records, {"record": "outcome"}]
    return "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines)


class ExperimentsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        program = self.folder / "program"
        others = {"smore_rebuild": REBUILD, "smore_score": SCORE}
        for file, text in ((program, PROGRAM), *((self.folder / name, text) for name, text in others.items())):
            file.write_text(text)
            file.chmod(0o755)
        (self.folder / "program.evidence").write_text(evidence_of_two_motions())
        self.calls = self.folder / "program.calls"
        self.addCleanup(setattr, trials, "PROGRAM", trials.PROGRAM)
        trials.PROGRAM = program
        self.addCleanup(setattr, learning, "PYTHON", learning.PYTHON)
        learning.PYTHON = self.folder / "missing"

    def seeds_called(self):
        return sorted(int(seed) for seed in self.calls.read_text().split())

    def test_a_finished_trial_is_not_run_again(self):
        first = [Trial(f"t{seed}", "scene", seed) for seed in (1, 2)]
        self.assertEqual(set(run(first, self.folder, 2)), {"t1", "t2"})
        records = run([*first, Trial("t3", "scene", 3)], self.folder, 2)
        self.assertEqual(records["t3"]["result"]["collisions"], 3)
        self.assertEqual(self.seeds_called(), [1, 2, 3])

    def test_a_trial_of_other_settings_is_another(self):
        run([Trial("t", "scene", 1)], self.folder, 1)
        run([Trial("t", "scene", 1, options=("--max-collisions", "7"))], self.folder, 1)
        self.assertEqual(self.seeds_called(), [1, 1])

    def test_a_trial_of_a_scene_that_has_changed_is_another(self):
        scene = self.folder / "scene.yaml"
        for text in ("voxel_size: 0.03", "voxel_size: 0.03", "voxel_size: 0.05"):
            scene.write_text(text)
            run([Trial("t", str(scene), 1)], self.folder, 1)
        self.assertEqual(self.seeds_called(), [1, 1])

    def test_a_trial_of_a_mesh_that_has_changed_is_another(self):
        scene, mesh = self.folder / "scene.yaml", self.folder / "part.stl"
        scene.write_text("object: {shapes: [{type: mesh, file: part.stl}]}")
        for text in ("solid a", "solid a", "solid b"):
            mesh.write_text(text)
            run([Trial("t", str(scene), 1)], self.folder, 1)
        self.assertEqual(self.seeds_called(), [1, 1])

    def test_a_trial_of_another_program_is_another(self):
        for text in (PROGRAM, PROGRAM, PROGRAM + "# another build\n"):
            trials.PROGRAM.write_text(text)
            run([Trial("t", "scene", 1)], self.folder, 1)
        self.assertEqual(self.seeds_called(), [1, 1])

    def test_a_trial_during_which_the_program_changes_is_not_kept(self):
        trials.PROGRAM.write_text(PROGRAM + "open(sys.argv[0], 'a').write('# another build')\n")
        with self.assertRaisesRegex(TrialError, "t: program or scene on .* differ"):
            run([Trial("t", "scene", 1)], self.folder, 1)
        self.assertEqual(Store(self.folder).finished, {})

    def test_a_trial_whose_scene_changes_while_it_waits_is_not_run(self):
        scene = self.folder / "scene.yaml"
        scene.write_text("voxel_size: 0.03")
        settings = Store(self.folder).settings(Trial("t", str(scene), 1))
        scene.write_text("voxel_size: 0.05")
        with self.assertRaisesRegex(TrialError, "differ"):
            trials.run_one(Trial("t", str(scene), 1), self.folder, settings)
        self.assertFalse(self.calls.exists())

    def test_a_directory_that_was_moved_keeps_its_trials(self):
        def asked(directory):
            return [trials.recorded("t", "scene", 1, "smore", directory)]

        run(asked(self.folder / "here"), self.folder / "here", 1)
        (self.folder / "here").rename(self.folder / "there")
        record = run(asked(self.folder / "there"), self.folder / "there", 1)["t"]
        self.assertEqual(self.seeds_called(), [1])
        self.assertTrue(trials.evidence_of(record).exists())

    def test_a_damaged_line_costs_its_own_trial_alone(self):
        some = [Trial(f"t{seed}", "scene", seed) for seed in (1, 2)]
        run(some, self.folder, 1)
        file = self.folder / "trials.jsonl"
        first, second = file.read_text().splitlines(True)
        for damaged in (b"\n", first[:20].encode() + b"\n", b"[]\n", b'{"trial": 1}\n', b"\xff\n"):
            file.write_bytes(damaged + second.encode())
            self.assertEqual(list(Store(self.folder).finished), ["t2"])
        self.assertEqual(set(run(some, self.folder, 1)), {"t1", "t2"})
        self.assertEqual(self.seeds_called(), [1, 1, 2])

    def test_a_line_that_was_cut_is_run_again_and_the_others_stay(self):
        run([Trial(f"t{seed}", "scene", seed) for seed in (1, 2)], self.folder, 1)
        file = self.folder / "trials.jsonl"
        whole = file.read_text()
        for length in range(len(whole.splitlines(True)[0]) + 1, len(whole)):
            file.write_text(whole[:length])
            self.assertEqual(list(Store(self.folder).finished), ["t1"])
        run([Trial(f"t{seed}", "scene", seed) for seed in (1, 2)], self.folder, 1)
        self.assertEqual(self.seeds_called(), [1, 2, 2])
        lines = file.read_text().splitlines()
        self.assertEqual([json.loads(line)["trial"]["seed"] for line in lines], [1, 2])

    def test_a_trial_that_fails_costs_no_other_and_is_named(self):
        some = [Trial(f"t{seed}", "scene", seed) for seed in (12, 13, 14)]
        with self.assertRaisesRegex(TrialError, "t13.*no thirteenth trial"):
            run(some, self.folder, 1)
        self.assertEqual(set(Store(self.folder).finished), {"t12", "t14"})

    def test_a_trial_that_broke_off_says_why(self):
        with self.assertRaisesRegex(TrialError, "t11.*the eleventh broke"):
            run([Trial("t11", "scene", 11)], self.folder, 1)

    def test_what_was_found_when_it_is_interrupted_is_kept_and_the_rest_not_begun(self):
        def interrupt(_progress):
            raise KeyboardInterrupt

        self.addCleanup(setattr, trials.Progress, "step", trials.Progress.step)
        trials.Progress.step = interrupt
        with self.assertRaises(KeyboardInterrupt):
            run([Trial(f"t{seed}", "scene", seed) for seed in range(1, 9)], self.folder, 2)
        kept = [record["trial"]["seed"] for record in Store(self.folder).finished.values()]
        self.assertEqual(sorted(kept), self.seeds_called())
        self.assertLess(len(kept), 8)

    def test_methods_are_told_apart_and_so_are_scenes(self):
        asked = [methods.trial(self.folder, "one_peg", method, seed) for method in methods.METHODS for seed in (7, 8)]
        asked.append(methods.trial(self.folder, "slit", "smore", 8))
        results = methods.results_of(run(asked, self.folder, 1))
        self.assertEqual(list(results), ["one_peg", "slit"])
        self.assertEqual(list(results["one_peg"]), list(methods.METHODS))
        self.assertEqual([result["seed"] for result in results["one_peg"]["chs"]], [7, 8])

    def test_only_methods_that_are_told_the_object_get_a_scene_that_tells_it(self):
        for name, method in methods.METHODS.items():
            trial = methods.trial(self.folder, "one_peg", name, 1)
            self.assertEqual(trial.method, method.name)
            if method.told:
                text = pathlib.Path(trial.scenario).read_text()
                self.assertTrue(text.startswith((ROOT / "config/scenarios/one_peg.yaml").read_text()))
                self.assertTrue(text.endswith("prior: {object: [{source: truth}]}\n"))
            else:
                self.assertEqual(trial.scenario, "one_peg")

    def test_means_are_of_the_trials_that_reached_the_goal(self):
        some = [{"collisions": count, "success": count < 60} for count in (2, 3, 10, 60)]
        self.assertEqual(methods.row(some), "5.0 | 3 | 2 | 10 | 3 of 4")
        self.assertEqual(methods.row(some[3:]), "- | - | - | - | 0 of 1")

    def test_all_scenes_of_the_rivals_exist(self):
        for scene in rivals.PLANAR + rivals.SPATIAL:
            self.assertTrue((ROOT / f"config/scenarios/{scene}.yaml").exists(), scene)

    def test_all_lines_of_figure_3_pass_through_the_voxel_at_different_places_of_the_object(self):
        places = set()
        for number in range(figure4.CONTACTS):
            record = lines_through_a_voxel.observation(number)
            point = np.array(record["line"]["point"])
            places.add(tuple(np.round(point, 6)))
            position = np.array(record["pose"]).reshape(3, 4)[:, 3]
            away = np.cross(record["line"]["direction"], np.array([*lines_through_a_voxel.TOUCHED, 0.0]) - position - point)
            self.assertLess(np.linalg.norm(away), 1e-12)
        self.assertEqual(len(places), figure4.CONTACTS)

    def test_the_free_law_makes_of_the_papers_example_what_the_paper_says(self):
        for got, printed in zip(figure4.free_law(*figure4.PAPER_BEFORE), figure4.PAPER_AFTER):
            self.assertAlmostEqual(got, printed, delta=0.005)

    def test_the_free_pose_lays_the_doubtful_voxel_on_the_touched_one(self):
        held = np.full((21, 21), np.nan)
        held[3, 4], held[7, 5] = 0.2, 0.9
        index = figure4.doubtful_voxel(held)
        self.assertEqual(tuple(index), (3, 4))
        middle = lines_through_a_voxel.middles()[1]
        laid = np.array(figure4.place_of(index, middle)) + figure4.free_pose(index)
        np.testing.assert_allclose(laid, lines_through_a_voxel.TOUCHED, atol=1e-12)

    def test_a_trial_whose_record_is_gone_is_run_again(self):
        asked = [trials.recorded("t", "scene", 1, "smore", self.folder)]
        run(asked, self.folder, 1)
        run(asked, self.folder, 1)
        self.assertEqual(self.seeds_called(), [1])
        asked[0].evidence().unlink()
        run(asked, self.folder, 1)
        self.assertEqual(self.seeds_called(), [1, 1])

    def test_a_recording_has_ways_lines_and_places_in_the_world(self):
        recording = Recording(self.folder / "program.evidence")
        first, second = recording.motions
        self.assertEqual((first.touched, second.touched), (True, False))
        self.assertEqual([recording.contacts_before(index) for index in (0, 1)], [0, 1])
        self.assertEqual([len(motion.way) for motion in recording.motions], [2 + 1 + 1, 2 + 1])
        point, direction = first.line
        np.testing.assert_allclose(point, [-0.12, 0.1, 0], atol=1e-12)
        np.testing.assert_allclose(direction, [-1, 0, 0], atol=1e-12)
        np.testing.assert_allclose(first.places, [[0, 0.15, 0]])
        self.assertEqual(moments(recording, 4), [0, 1])

    def test_maps_before_a_motion_are_made_once_of_what_was_observed_by_then(self):
        whole = (self.folder / "program.evidence").read_text()
        recording = Recording(self.folder / "program.evidence")
        for index, motions in ((0, 0), (1, 1), (2, 2)):
            world, held = recording.maps_before(index, self.folder / "maps")
            self.assertEqual((world[2][0], held[2][0]), (0.5, 0.5))
            given = self.folder / f"maps/before_motion_{index}/summary.json"
            self.assertTrue(whole.startswith(given.read_text()))
            self.assertEqual(given.read_text().count('"record":"motion"'), motions)
            made = given.stat().st_mtime_ns
            recording.maps_before(index, self.folder / "maps")
            self.assertEqual(given.stat().st_mtime_ns, made)
            self.assertFalse(list((self.folder / "maps").glob("*.evidence")))

    def test_evidence_told_anew_has_fewer_free_poses_or_another_order(self):
        lines = evidence_of_two_motions().encode().splitlines(keepends=True)
        thin = replays.thinned(lines, 10)
        self.assertEqual(len(lines) - len(thin), 121 - 12)
        self.assertEqual([line for line in thin if FREE not in line], [line for line in lines if FREE not in line])
        orders = [replays.reordered(lines, seed) for seed in range(8)]
        self.assertIn(lines, orders)
        self.assertTrue(any(order != lines for order in orders))
        for order in orders:
            self.assertEqual((sorted(order), order[:3], order[-1]), (sorted(lines), lines[:3], lines[-1]))
            self.assertIn(replays.MOTION, order[3])
        self.assertEqual(replays.reordered(lines[:3], 1), lines[:3])

    def test_a_sweep_covers_the_workspace_from_all_sides_coarsely_first(self):
        low, high = np.array([-0.5, -0.4, 0.1]), np.array([0.7, 0.6, 1.2])
        directions, begins = [], []
        for motion in sweep.motions((low, high), np.array([0.6, 0.0, 0.9])):
            self.assertTrue(all(np.all(place >= low) and np.all(place <= high) for place, _rpy in motion))
            (begin, rpy), (end, _rpy) = motion[2:4]
            ahead = rotation_of(rpy) @ [0, 0, -1]  # where a rod that hangs down points to
            self.assertGreater(ahead @ (end - begin), 0)
            directions.append(tuple(np.sign(end - begin).astype(int)))
            begins.append(begin)
        first_round = directions[: len(directions) // 3]
        self.assertEqual(set(first_round), {(0, 0, -1), (-1, 0, 0), (0, -1, 0), (1, 0, 0), (0, 1, 0)})
        for axis, name in ((0, (0, 0, -1)), (1, (1, 0, 0)), (2, (0, 1, 0))):
            places = np.unique([begin[axis] for begin, way in zip(begins, directions) if way == name])
            self.assertLessEqual(np.diff([low[axis], *places, high[axis]]).max(), sweep.APART / 2 + 1e-9)

    def test_an_animation_shows_each_motion_to_its_end(self):
        recording = Recording(self.folder / "program.evidence")
        shown = animation.frames(recording)
        self.assertEqual(shown[-1], (1, len(recording.motions[1].way)))
        self.assertTrue(all(1 <= behind <= len(recording.motions[index].way) for index, behind in shown))

    def test_soft_actor_critic_is_asked_for_where_it_is_not_set_up(self):
        asked = figure7.trials(self.folder, True)
        self.assertNotIn("sac", {trial.method for trial in asked})
        text, figures = figure7.report(run(asked, self.folder, 2), self.folder)
        self.assertIn("scripts/experiments --setup", text)
        self.assertEqual(list(figures), ["figure7"])

    def test_soft_actor_critic_stands_beside_the_methods_where_it_is_set_up(self):
        learning.PYTHON = trials.PROGRAM
        self.addCleanup(setattr, learning, "is_set_up", learning.is_set_up)
        learning.is_set_up = lambda: True
        text, figures = figure7.report(run(figure7.trials(self.folder, False), self.folder, 2), self.folder)
        self.assertRegex(text, r"\| sac \| .* \| 4 of 5 \|")
        self.assertIn("| 1002 | 100200 | 2 | at the goal |", text)
        self.assertEqual(list(figures), ["figure7", "figure7_sac"])

    def test_each_experiment_draws_its_figures(self):
        scene = self.folder / "scenes/planar_1001.yaml"
        scene.parent.mkdir()
        figures_of_paper = (figure3, figure4, figure5, figure6, figure7, figure8, figure9, figure10)
        for experiment in (*figures_of_paper, rivals, calibration, sensitivity, choices, generality):
            if experiment is generality:
                drawn = {"object": "star", "obstacles": "pegs", "scale": 2.5, "rejected": {"no way out was found": 2}}
                names = ("planar_1001", "spatial_1001", "spatial_slit_1001")
                (scene.parent / "scenes.json").write_text(json.dumps(dict.fromkeys(names, drawn)))
                asked = [Trial(name, str(scene), 1001) for name in names]
            else:
                asked = experiment.trials(self.folder, True)
            text, figures = experiment.report(run(asked, self.folder / experiment.__name__, 2), self.folder)
            self.assertTrue(text.startswith("| "), text)
            self.assertTrue(figures)
            for figure in figures.values():
                self.assertIsInstance(figure, (matplotlib.figure.Figure, matplotlib.animation.Animation))


if __name__ == "__main__":
    unittest.main()
