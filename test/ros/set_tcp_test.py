#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""robot.launch refuses an arm on whose pendant a TCP is set."""

import unittest

import rospy
import rostest
from sensor_msgs.msg import JointState

from node_killing import MOVES, speed
from node_testing import Recorder, start_node
from retrieve_client import RetrieveClient


class SetTcp(unittest.TestCase):
    def test_the_goal_is_refused_with_the_offset_and_the_remedy_and_nothing_moves(self):
        start_node("set_tcp_test")
        joints = Recorder("/joint_states", JointState)
        result = RetrieveClient().retrieve()
        self.assertFalse(result.success)
        offset = rospy.get_param("~offset")
        for words in (f"{offset}) m in the tool's axes", "TCP set on the pendant, set it to zero"):
            self.assertIn(words, result.message)
        self.assertLess(max(speed(m) for m in joints.messages()), MOVES)


if __name__ == "__main__":
    rostest.rosrun("smore", "set_tcp_test", SetTcp)
