#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""An arm that tilts its object finds the weight first, and feels none of it afterwards."""

import math
import unittest

import rostest
from geometry_msgs.msg import Pose, PoseStamped, WrenchStamped

from node_testing import Recorder, start_node
from retrieve_client import RetrieveClient
from smore.msg import ContactObservation, RetrieveGoal


def distance(a, b):
    return math.dist((a.x, a.y, a.z), (b.x, b.y, b.z))


def upright_at(x, y, z):
    """Of the object, as it stands at the start."""
    goal = RetrieveGoal(goal=PoseStamped(pose=Pose()))
    goal.goal.header.frame_id = "world"
    goal.goal.pose.position.x, goal.goal.pose.position.y, goal.goal.pose.position.z = x, y, z
    goal.goal.pose.orientation.z = goal.goal.pose.orientation.w = math.sqrt(0.5)
    return goal


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
        self.tilts_where_it_is(contact, compensated)

    def tilts_where_it_is(self, contact, compensated):
        """A goal in another place than the start: the way there is over before it tilts."""
        compensated.close()
        contact.clear()
        result = RetrieveClient().retrieve(goal=upright_at(0.5, 0.03, 0.25))
        self.assertTrue(result.success, result.message)
        places = [message.pose.position for message in contact.messages()]
        turns = sum(distance(a, b) for a, b in zip(places, places[1:]))
        self.assertLess(max(distance(place, places[0]) for place in places), 0.1)
        self.assertGreater(turns, 0.03)


if __name__ == "__main__":
    rostest.rosrun("smore", "tilted_goal", TiltedGoal)
