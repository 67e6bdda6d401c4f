#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""robot.launch on an arm that the description which it is given does not know to the millimetre."""

import math
import unittest

import actionlib
import rospy
import rostest
from geometry_msgs.msg import Pose, Quaternion
from rosgraph_msgs.msg import Log

from node_testing import DEADLINE, Recorder, stamped, start_node
from smore.msg import ContactObservation, RetrieveAction, RetrieveGoal

NEAR = 0.03  # a goal that nothing is in the way of [m]
AT_TARGET = 2e-3  # [m]
STRAIGHT = 1.5e-3  # [m]; a motion that began with a jump would be off by the calibration, 5 mm
LONG = rospy.Duration(60.0)  # only failing tests wait so long


class CalibratedArm(unittest.TestCase):
    def test_the_object_arrives_where_tf_has_it_and_on_a_straight_way(self):
        start_node("calibrated_arm_test")
        log = Recorder("/rosout", Log)
        contacts = Recorder("contact", ContactObservation)
        client = actionlib.SimpleActionClient("retrieve", RetrieveAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(DEADLINE)))
        goal = Pose()
        goal.position.x, goal.position.y, goal.position.z = 0.5, 0.14 - NEAR, 0.12
        goal.orientation = Quaternion(0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
        client.send_goal(RetrieveGoal(goal=stamped(goal)))
        self.assertTrue(client.wait_for_result(LONG))
        result = client.get_result()
        self.assertTrue(result.success, result.message)
        self.assertIsNotNone(log.wait_for(lambda m: "tf has the tool" in m.msg), "the arm is not off")
        poses = [m.pose.position for m in contacts.messages()]
        self.assertLess(max(abs(p.x - 0.5) for p in poses), STRAIGHT)
        self.assertLess(max(abs(p.z - 0.12) for p in poses), STRAIGHT)
        self.assertLess(abs(poses[-1].y - goal.position.y), AT_TARGET)


if __name__ == "__main__":
    rostest.rosrun("smore", "calibrated_arm_test", CalibratedArm)
