#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each node refuses bad parameters: all problems at once, exit code 2."""

import subprocess
import tempfile
import unittest

import rospkg
import rosparam
import roslib.packages
import rostest

from node_testing import DEADLINE, start_node

PACKAGE = rospkg.RosPack().get_path("smore")
NODES = ["simulator", "force_torque", "mapping", "planner", "retrieval"]
NEEDS_METHOD = ["mapping", "planner", "retrieval"]


def shipped(node):
    parameters, _ = rosparam.load_file(f"{PACKAGE}/config/{node}.yaml")[0]
    parameters["scenario"] = f"{PACKAGE}/test/ros/small_scene.yaml"
    if node in NEEDS_METHOD:
        parameters["method"] = "paper"
    if node == "retrieval":
        parameters["auto_start"] = False
    return parameters


def run(node, parameters):
    """Exit code and output of a node with these parameters."""
    name = f"/{node}_under_test"
    rosparam.delete_param(name) if name in rosparam.list_params("/") else None
    rosparam.upload_params(name, parameters)
    program = roslib.packages.find_node("smore", f"{node}_node")[0]
    process = subprocess.run(
        [program, f"__name:={name[1:]}"],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=DEADLINE, check=False,
    )  # fmt: skip
    rosparam.delete_param(name)
    return process.returncode, process.stdout.decode()


class Parameters(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("parameters_test")

    def refused(self, node, parameters, *words):
        code, output = run(node, parameters)
        self.assertEqual(code, 2, output)
        for word in words:
            self.assertIn(word, output)

    def test_unknown_missing_and_impossible_values_are_told_together(self):
        for node in NODES:
            parameters = shipped(node)
            del parameters["world_frame"]
            parameters["object_frame"] = ""
            parameters["colour"] = "blue"
            with self.subTest(node=node):
                self.refused(
                    node, parameters, "world_frame: missing", "object_frame: expected a text",
                    "colour: unknown key",
                )  # fmt: skip

    def test_the_guard_tells_all_problems_together(self):
        parameters = shipped("guard")
        del parameters["max_silence"]
        parameters["max_force"] = -1.0
        parameters["colour"] = "blue"
        self.refused("guard", parameters, "max_silence: missing", "max_force", "colour: unknown key")

    def test_scenarios_that_cannot_be_read_are_named(self):
        for node in NODES:
            parameters = shipped(node)
            parameters["scenario"] = "/nowhere/scene.yaml"
            with self.subTest(node=node):
                self.refused(node, parameters, "/nowhere/scene.yaml")

    def test_what_simulates_refuses_a_task_in_one_line(self):
        tasks = {"simulator": f"{PACKAGE}/test/ros/small_task.yaml", "robot_twin": f"{PACKAGE}/config/tasks/ur5e.yaml"}
        for node, task in tasks.items():
            parameters = shipped(node)
            parameters["scenario"] = task
            with self.subTest(node=node):
                code, output = run(node, parameters)
                self.assertEqual(code, 2, output)
                fatal = [line for line in output.splitlines() if "[FATAL]" in line]
                self.assertEqual(len(fatal), 1, output)
                self.assertIn("object, environment: missing; without shapes it is a task", fatal[0])

    def test_a_threshold_other_than_the_scenarios_is_refused(self):
        parameters = shipped("force_torque")
        parameters["detector"]["contact_force"] = 7.0
        self.refused("force_torque", parameters, "detector.contact_force", "7", "scenario")

    def test_values_out_of_range_are_refused(self):
        parameters = shipped("simulator")
        parameters["lag_samples"] = -1
        parameters["clock_period"] = "often"
        self.refused("simulator", parameters, "lag_samples", "clock_period")

    def test_a_file_of_parameters_is_read_as_the_programs_read_it(self):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write("belief: {radios: 0.3, sweeps: many}\nplanner: {paths: 0}\n")
            file.flush()
            for node in ("mapping", "planner"):
                parameters = shipped(node)
                parameters["method"] = "smore"
                parameters["parameters"] = file.name
                with self.subTest(node=node):
                    self.refused(
                        node, parameters, "belief.radios: unknown key", "belief.sweeps", "planner.paths"
                    )
                    parameters["method"] = "cspace"
                    self.refused(node, parameters, "the method cspace has no parameters")
                    parameters["method"] = "paper"
                    parameters["parameters"] = "/nowhere/parameters.yaml"
                    self.refused(node, parameters, "/nowhere/parameters.yaml: cannot be read")

    def test_an_unknown_method_is_refused(self):
        for node in NEEDS_METHOD:
            parameters = shipped(node)
            parameters["method"] = "magic"
            with self.subTest(node=node):
                self.refused(node, parameters, "method", "paper, cspace, smore")


if __name__ == "__main__":
    rostest.rosrun("smore", "parameters_test", Parameters)
