#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A wrench of the wrong sign ends the retrieval at the first touch, which says so."""

import unittest

import actionlib
import rospy
import rostest

from node_testing import DEADLINE, start_node
from smore.msg import RetrieveAction, RetrieveGoal

LONG = rospy.Duration(80.0)  # only failing tests wait so long


class WrenchSign(unittest.TestCase):
    def test_the_first_touch_ends_the_goal_with_the_parameter_that_fits(self):
        start_node("wrench_sign_test")
        client = actionlib.SimpleActionClient("retrieve", RetrieveAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(DEADLINE)))
        client.send_goal(RetrieveGoal())
        self.assertTrue(client.wait_for_result(LONG))
        result = client.get_result()
        self.assertFalse(result.success)
        self.assertIn("(wrench_sign: -1)", result.message)


if __name__ == "__main__":
    rostest.rosrun("smore", "wrench_sign_test", WrenchSign)
