#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""All nodes together bring the object to the goal, and the maps know what was touched."""

import unittest

import rostest
from octomap_msgs.msg import Octomap

from node_testing import Recorder, start_node
from retrieve_client import RetrieveClient


class System(unittest.TestCase):
    def test_the_object_reaches_the_goal_after_contacts_that_the_maps_show(self):
        start_node("system_test")
        phases = []
        result = RetrieveClient().retrieve(lambda feedback: phases.append(feedback.phase))
        self.assertTrue(result.success, result.message)
        self.assertGreater(result.collisions, 0, "a way without a touch shows nothing")
        self.assertGreater(result.plans, result.collisions)
        self.assertIn("moving", phases)
        for name in ("world/octomap_full", "object/octomap_full"):
            self.assertIsNotNone(Recorder(name, Octomap).wait_for(lambda map_: len(map_.data) > 0))


if __name__ == "__main__":
    rostest.rosrun("smore", "system_test", System)
