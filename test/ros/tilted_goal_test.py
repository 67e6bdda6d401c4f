#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""An arm that tilts its object finds the weight first, and feels none of it afterwards."""

import unittest

import rostest
from geometry_msgs.msg import WrenchStamped

from node_testing import Recorder, start_node
from retrieve_client import RetrieveClient
from smore.msg import ContactObservation


class TiltedGoal(unittest.TestCase):
    def test_the_goal_is_reached_without_feeling_the_weight(self):
        start_node("tilted_goal_test")
        contact = Recorder("contact", ContactObservation)
        compensated = Recorder("wrench_compensated", WrenchStamped)
        result = RetrieveClient().retrieve()
        self.assertTrue(result.success, result.message)
        self.assertEqual(result.collisions, 0, "weight was taken for contact")
        free = contact.wait_for(lambda message: message.state == ContactObservation.FREE)
        self.assertIsNotNone(free)
        compensated.clear()
        force = compensated.wait_for(lambda message: True).wrench.force
        for component in (force.x, force.y, force.z):
            self.assertLess(abs(component), 1.5)


if __name__ == "__main__":
    rostest.rosrun("smore", "tilted_goal", TiltedGoal)
