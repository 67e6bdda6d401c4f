#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""robot.launch on an arm that the description which it is given does not know to the millimetre."""

import math
import unittest

import numpy as np
import rostest
from geometry_msgs.msg import Pose, Quaternion
from nav_msgs.msg import Path
from rosgraph_msgs.msg import Log

from node_testing import Recorder, stamped, start_node
from retrieve_client import RetrieveClient
from smore.msg import ContactObservation, RetrieveGoal

NEAR = 0.03  # a goal that nothing is in the way of [m]
AT_TARGET = 2e-3  # [m]
ON_THE_WAY = 2.5e-3  # [m]; a motion that began with a jump would be off by the calibration, 5 mm


def position(message):
    p = message.pose.position
    return np.array([p.x, p.y, p.z])


def distance(point, way):
    """From the nearest point of the legs of `way` [m]."""
    nearest = []
    for a, b in zip(way, way[1:]):
        share = np.clip(np.dot(point - a, b - a) / max(np.dot(b - a, b - a), 1e-12), 0.0, 1.0)
        nearest.append(np.linalg.norm(a + share * (b - a) - point))
    return min(nearest)


class CalibratedArm(unittest.TestCase):
    def test_the_object_arrives_where_tf_has_it_on_the_way_that_was_planned(self):
        start_node("calibrated_arm_test")
        log = Recorder("/rosout", Log)
        contacts = Recorder("contact", ContactObservation)
        plans = Recorder("path", Path)
        goal = Pose()
        goal.position.x, goal.position.y, goal.position.z = 0.5, 0.14 - NEAR, 0.12
        goal.orientation = Quaternion(0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
        result = RetrieveClient().retrieve(goal=RetrieveGoal(goal=stamped(goal)))
        self.assertTrue(result.success, result.message)
        self.assertIsNotNone(log.wait_for(lambda m: "tf has the tool" in m.msg), "the arm is not off")
        way = [position(stamped_pose) for stamped_pose in plans.wait_for(lambda m: m.poses).poses]
        seen = [position(message) for message in contacts.messages()]
        self.assertLess(max(distance(point, way) for point in seen), ON_THE_WAY)
        self.assertLess(np.linalg.norm(seen[-1] - way[-1]), AT_TARGET)


if __name__ == "__main__":
    rostest.rosrun("smore", "calibrated_arm_test", CalibratedArm)
