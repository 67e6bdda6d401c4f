#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Random scenes are what they are said to be: blocked straight ahead, with a way out in the true geometry.

    test_random_scenes.py
"""
import collections
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
import random_spatial_shapes  # noqa: E402
from lattice import circle, flood  # noqa: E402
from scene_geometry import rotation_of  # noqa: E402
from scene_writer import box, cylinder  # noqa: E402
from spatial_scene import STEP, BlockedPlaces, Spatial, distance_to, rod, rotations_of_lattice  # noqa: E402


def steps_one_by_one(free, start, goal, beside):
    """What flood counts, cell by cell."""
    steps, front = {start: 0}, collections.deque([start])
    while front:
        cell = front.popleft()
        near = [(turn, *cell[1:]) for turn in beside[cell[0]]]
        for axis in range(1, free.ndim):
            for sign in (1, -1):
                near.append(tuple(at + sign * (axis == each) for each, at in enumerate(cell)))
        for other in near:
            inside = all(0 <= at < count for at, count in zip(other, free.shape))
            if inside and free[other] and other not in steps:
                steps[other] = steps[cell] + 1
                front.append(other)
    return steps.get(goal) if free[start] else None


def wall_with_slit(width):
    """A slit along z in a wall across the way."""
    return [box((0.04, 2, 2), (-0.5, sign * (1 + width / 2), 0)) for sign in (1, -1)]


class RandomScenesTest(unittest.TestCase):
    def test_a_flood_takes_as_many_steps_as_a_search_cell_by_cell(self):
        draw = np.random.default_rng(1)
        found = 0
        for trial in range(200):
            free = draw.random((5, 4, 5, 3)[: 3 + trial % 2]) < 0.6
            beside = circle(5)
            start, goal = (tuple(int(draw.integers(count)) for count in free.shape) for _ in range(2))
            expected = steps_one_by_one(free, start, goal, beside)
            self.assertEqual(flood(free, start, goal, beside), expected)
            found += expected is not None
        self.assertGreater(found, 30)
        self.assertLess(found, 170)

    def test_distances_to_solids_are_those_to_the_nearest_of_many_points_on_them(self):
        draw, rpy, middle = np.random.default_rng(2), (0.3, -0.5, 1.1), np.array([0.1, -0.2, 0.3])
        side, angle = np.linspace(-1, 1, 81), np.linspace(0, 2 * np.pi, 161)
        u, v = np.meshgrid(side, side)
        faces = [np.roll(np.stack([np.full(u.shape, s), u, v], -1), k, -1) for s in (1, -1) for k in range(3)]
        on_box = np.concatenate(faces).reshape(-1, 3) * (0.2, 0.05, 0.1)
        rim = 0.1 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], -1)
        mantle = (rim + 0.2 * side[:, None, None] * (0, 0, 1)).reshape(-1, 3)
        cap = (np.linspace(0, 1, 41)[:, None, None] * rim).reshape(-1, 3) + (0, 0, 0.2)
        on_cylinder = np.concatenate([mantle, cap, cap * (1, 1, -1)])
        a_box, a_cylinder = box((0.4, 0.1, 0.2), middle, rpy), cylinder(0.1, 0.4, middle, rpy)
        for solid, surface in ((a_box, on_box), (a_cylinder, on_cylinder)):
            surface = surface @ rotation_of(rpy).T + middle
            points = middle + draw.uniform(-0.5, 0.5, (300, 3))
            nearest = np.linalg.norm(points[:, None] - surface, axis=-1).min(axis=1)
            np.testing.assert_allclose(np.abs(distance_to(solid, points)), nearest, atol=0.006)
            self.assertLess(distance_to(solid, middle), 0)

    def test_a_rod_goes_from_one_end_to_the_other(self):
        start, end = np.array([0.1, -0.2, 0.3]), np.array([-0.3, 0.1, -0.1])
        solid = rod(start, end, 0.02)
        for share in (0.01, 0.5, 0.99):
            self.assertLess(distance_to(solid, start + share * (end - start)), 0)
        for share in (-0.1, 1.1):
            self.assertGreater(distance_to(solid, start + share * (end - start)), 0.04)

    def test_rotations_that_are_neighbours_are_six_degrees_apart(self):
        rotations, beside = rotations_of_lattice()
        for turn, near in enumerate(beside):
            for other in set(near) - {turn}:
                cosine = (np.trace(rotations[turn].T @ rotations[other]) - 1) / 2
                self.assertAlmostEqual(np.degrees(np.arccos(cosine)), 6, places=6)
        self.assertEqual(len(set(beside[0])), 6)

    def test_places_of_the_lattice_count_as_free_with_the_margin_only(self):
        draw = random.Random(3).random
        for made, placed in zip(random_spatial_shapes.OBJECTS, random_spatial_shapes.OBSTACLES):
            scene = made(draw)
            scene.place_among(placed(draw))
            axes = [np.arange(-4, 5) * STEP] * 3
            free = BlockedPlaces(scene, axes, 0.02).places_without(scene.balls(), (9, 9, 9))
            places = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
            clearance = scene.clearance(places).reshape(free.shape)
            self.assertFalse((free & (clearance < 0.02)).any())
            self.assertFalse((~free & (clearance > 0.02 + 0.014)).any())  # twice half a cell's diagonal

    def test_a_bar_turns_to_pass_a_slit_and_cannot_pass_one_that_is_too_narrow(self):
        across = Spatial(0.02).bar((0, -0.2, 0), (0, 0.2, 0))
        across.solids = wall_with_slit(0.2)
        self.assertTrue(across.straight_way_is_blocked())
        turned = across.detour(margin=0.02)
        self.assertGreater(turned, 0.98)
        across.solids = wall_with_slit(0.07)
        self.assertIsNone(across.detour(margin=0.02))
        upright = Spatial(0.02).bar((0, 0, -0.2), (0, 0, 0.2))
        upright.solids = wall_with_slit(0.2)
        self.assertFalse(upright.straight_way_is_blocked())

    def test_objects_stay_within_reach_and_obstacles_are_drawn_anew(self):
        draw = random.Random(4).random
        for made in random_spatial_shapes.OBJECTS:
            for _ in range(20):
                scene = made(draw)
                self.assertLess(scene.reach(), 0.55)
                self.assertGreater(len(scene.bars), 2)
        for placed in random_spatial_shapes.OBSTACLES:
            self.assertNotEqual(str(placed(draw).solids[0]), str(placed(draw).solids[0]))

    def test_a_scene_follows_from_its_seed_and_is_not_drawn_again(self):
        with tempfile.TemporaryDirectory() as folder:
            texts = []
            for output in ("a", "b", "a"):
                command = [ROOT / "scripts/random_scenes", "--motion", "spatial", "--seed", "13", "--count", "1"]
                subprocess.run([*command, "--output", f"{folder}/{output}"], check=True, stdout=subprocess.DEVNULL)
                texts.append(pathlib.Path(folder, output, "spatial_13.yaml").read_text())
            self.assertEqual(texts[0], texts[1])
            self.assertEqual(texts[0], texts[2])
            said = json.loads(pathlib.Path(folder, "a/scenes.json").read_text())["spatial_13"]
        self.assertEqual((said["object"], said["obstacles"]), ("object of a wire", "obstacles of a frame"))

    def test_all_scenes_may_have_obstacles_of_one_kind(self):
        with tempfile.TemporaryDirectory() as folder:
            command = [ROOT / "scripts/random_scenes", "--seed", "5", "--count", "2", "--output", folder, "--obstacles"]
            subprocess.run([*command, "bracket"], check=True, stdout=subprocess.DEVNULL)
            said = json.loads(pathlib.Path(folder, "scenes.json").read_text())
            refused = subprocess.run([*command, "slit"], stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(set(said), {"planar_bracket_5", "planar_bracket_6"})
        self.assertEqual({scene["obstacles"] for scene in said.values()}, {"obstacles of a bracket"})
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--motion planar has pegs, walls, bracket, gap", refused.stderr)


if __name__ == "__main__":
    unittest.main()
