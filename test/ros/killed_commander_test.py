#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""In a simulation without a guard the arm stops with who commands it."""

import os
import signal
import unittest

import rostest

from node_killing import MOST, RunningLoop, Simulator
from node_testing import start_node

TESTS = os.path.dirname(os.path.abspath(__file__))
LAUNCH_FILE = os.path.join(TESTS, os.pardir, os.pardir, "launch", "loop.launch")


class KilledCommander(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("killed_commander_test")
        cls.simulator = Simulator()

    def setUp(self):
        self.assertTrue(self.simulator.reset().success)
        self.loop = RunningLoop(LAUNCH_FILE, "ur5e_one_peg_quiet")
        self.addCleanup(self.loop.end)
        self.assertTrue(self.simulator.wait_for_motion())

    def stands_after(self, end_node, *arguments):
        self.assertLess(self.simulator.rest_after(lambda: end_node(*arguments)), MOST)

    def test_the_retrieval_is_killed(self):
        self.stands_after(self.loop.signal, "retrieval", signal.SIGKILL)

    def test_the_retrieval_is_interrupted(self):
        self.stands_after(self.loop.signal, "retrieval", signal.SIGINT)

    def test_the_listener_is_killed(self):
        self.stands_after(self.loop.signal, "force_torque", signal.SIGKILL)


if __name__ == "__main__":
    rostest.rosrun("smore", "killed_commander", KilledCommander)
