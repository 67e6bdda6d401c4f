#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""robot.launch on the twin of a UR5e's driver, whose speed slider somebody moves meanwhile. The first test begins at the start,
the second wherever that has ended."""

import math
import unittest

import actionlib
import rospy
import rostest
from geometry_msgs.msg import Pose, Quaternion
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64

from action_clients import has_ended
from node_killing import MOVES, STANDS, speed
from node_testing import DEADLINE, Recorder, stamped, start_node, wait_until
from smore.msg import ContactObservation, RetrieveAction, RetrieveGoal

SLOW = 0.1  # as the first run on a real arm begins
PAUSE = 8.0  # far longer than the motion's time and its slack at full speed [s]
NEAR = 0.03  # a goal that nothing is in the way of [m]
LONG = 100.0  # to reach it [s]; only failing tests wait so long


class Slider(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("robot_slider_test")
        cls.joints = Recorder("/joint_states", JointState)
        cls.contacts = Recorder("contact", ContactObservation)
        cls.slider = rospy.Publisher("robot_twin/slider", Float64, queue_size=1, latch=True)
        cls.scaling = Recorder("/speed_scaling_factor", Float64)
        cls.client = actionlib.SimpleActionClient("retrieve", RetrieveAction)
        assert cls.client.wait_for_server(rospy.Duration(DEADLINE))

    def tearDown(self):
        self.set_slider(1.0)
        self.client.cancel_goal()
        has_ended(self.client)

    def set_slider(self, share):
        self.scaling.clear()
        self.slider.publish(share)
        self.assertIsNotNone(self.scaling.wait_for(lambda m: m.data == share))

    def retrieve(self, goal):
        self.phases = []
        self.joints.clear()
        self.contacts.clear()
        self.client.send_goal(goal, feedback_cb=lambda feedback: self.phases.append(feedback.phase))

    def pause_for(self, duration):
        """By the clock of the arm's own joint states."""
        self.set_slider(0.0)
        self.joints.clear()
        begin = self.joints.wait_for(lambda m: speed(m) < STANDS)
        self.assertIsNotNone(begin, "it does not stand in the pause")
        end = begin.header.stamp + rospy.Duration(duration)
        self.assertIsNotNone(self.joints.wait_for(lambda m: m.header.stamp > end))

    def test_a_paused_and_slow_robot_arrives_when_it_goes_on(self):
        self.set_slider(SLOW)
        goal = Pose()
        goal.position.x, goal.position.y, goal.position.z = 0.5, 0.14 - NEAR, 0.12
        goal.orientation = Quaternion(0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
        self.retrieve(RetrieveGoal(goal=stamped(goal)))
        self.assertIsNotNone(self.joints.wait_for(lambda m: speed(m) > SLOW * MOVES))
        self.pause_for(PAUSE)
        self.set_slider(SLOW)
        self.assertTrue(has_ended(self.client, LONG))
        result = self.client.get_result()
        self.assertTrue(result.success, result.message)
        self.assertEqual(self.phases.count("moving"), 1, "it took more than one motion")

    def test_a_retreat_is_not_over_in_a_pause(self):
        self.retrieve(RetrieveGoal())
        touches = lambda m: m.state == ContactObservation.CONTACT
        self.assertIsNotNone(self.contacts.wait_for(touches), "it touches nothing")
        self.assertTrue(wait_until(lambda: "retreating" in self.phases), "no retreat")
        self.contacts.clear()
        free = lambda m: m.state == ContactObservation.FREE
        self.assertIsNotNone(self.contacts.wait_for(free))
        self.pause_for(2.0)
        self.assertEqual(self.phases[-1], "retreating")
        self.set_slider(1.0)
        self.assertTrue(wait_until(lambda: self.phases[-1] != "retreating"), "it does not go on")
        self.assertEqual(self.phases[-1], "planning")


if __name__ == "__main__":
    rostest.rosrun("smore", "robot_slider_test", Slider)
