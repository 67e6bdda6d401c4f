#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A force above the guard's ceiling stops the simulated arm in its motion, and the retrieval."""

import unittest

import rospy
import rostest
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from std_srvs.srv import Trigger

from node_testing import Recorder, start_node, wait_until
from retrieve_client import RetrieveClient

AT_REST = 1e-3  # [rad/s]


class GuardedArm(unittest.TestCase):
    def test_a_force_above_the_ceiling_stops_arm_and_retrieval(self):
        start_node("guarded_arm_test")
        fault = Recorder("guard/fault", String)
        client = RetrieveClient()
        result = client.retrieve()
        self.assertFalse(result.success)
        self.assertIn("the guard has stopped the robot: the force", result.message)
        self.assertIsNotNone(fault.wait_for(lambda message: "the force" in message.data))

        joints = Recorder("/joint_states", JointState)
        standing = joints.wait_for(lambda m: all(abs(v) < AT_REST for v in m.velocity))
        self.assertIsNotNone(standing, "the arm did not stop")

        self.assertIn("the guard", client.retrieve().message, "moved before the fault was cleared")

        clear = rospy.ServiceProxy("guard/clear", Trigger)
        self.assertTrue(clear().success)
        self.assertTrue(wait_until(lambda: fault.messages()[-1].data == ""))


if __name__ == "__main__":
    rostest.rosrun("smore", "guarded_arm", GuardedArm)
