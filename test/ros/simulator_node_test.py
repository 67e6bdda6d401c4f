#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The simulator alone; the test plays the listener that it runs in lock-step with."""

import unittest

import rospy
import rostest
from geometry_msgs.msg import WrenchStamped
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint
from visualization_msgs.msg import MarkerArray

from node_testing import PERIOD, Recorder, start_node, wait_until
from smore.msg import ContactObservation

JOINTS = ["x_joint", "y_joint", "z_joint", "yaw_joint", "pitch_joint", "roll_joint"]
LAG = 2  # samples, as in config/simulator.yaml


class SimulatorNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("simulator_node_test")
        cls.wrenches = Recorder("wrench", WrenchStamped)
        cls.transforms = Recorder("/tf", TFMessage)
        cls.joints = Recorder("joint_states", JointState)
        cls.clock = Recorder("/clock", Clock)
        cls.contact = rospy.Publisher(
            "contact", ContactObservation, queue_size=1000, tcp_nodelay=True
        )
        cls.command = rospy.Publisher("command", JointTrajectory, queue_size=1)
        cls.reset = rospy.ServiceProxy("simulator/reset", Trigger)
        assert cls.wrenches.wait_for_publisher()
        assert wait_until(lambda: cls.contact.get_num_connections() > 0)
        assert wait_until(lambda: cls.command.get_num_connections() > 0)
        cls.contact_id = 0
        cls.answered = rospy.Time()

    def setUp(self):
        self.assertTrue(self.reset().success)
        self.assertTrue(self.step_until(lambda: abs(self.x()) < 1e-6))

    def x(self):
        """Where the object is by the newest transform [m]."""
        messages = self.transforms.messages()
        return messages[-1].transforms[0].transform.translation.x if messages else None

    def answer(self, state=ContactObservation.FREE):
        """Answers the newest wrench; returns its stamp."""
        newest = self.wrenches.wait_for(lambda message: message.header.stamp > self.answered)
        self.assertIsNotNone(newest, "the simulation stands still")
        stamp = self.wrenches.messages()[-1].header.stamp
        for recorder in (self.wrenches, self.joints, self.clock):
            recorder.clear()
        observation = ContactObservation()
        observation.header.stamp = stamp
        observation.state = state
        observation.contact_id = self.contact_id
        self.contact.publish(observation)
        type(self).answered = stamp
        return stamp

    def step_until(self, condition, most=5000):
        for _ in range(most):
            self.answer()
            if condition():
                return True
        return False

    def move_to(self, x, joints=None):
        message = JointTrajectory(joint_names=joints or JOINTS)
        message.points = [JointTrajectoryPoint(positions=[x, 0, 0, 0, 0, 0])]
        self.command.publish(message)

    def test_samples_come_at_500_hz_of_its_own_time_each_with_its_pose(self):
        stamps = [self.answer() for _ in range(100)]
        with_pose = {message.transforms[0].header.stamp for message in self.transforms.messages()}
        for before, after in zip(stamps, stamps[1:]):
            samples = (after - before).to_sec() / PERIOD
            self.assertAlmostEqual(samples, round(samples), 6)
            self.assertIn(before, with_pose)
        transform = self.transforms.messages()[-1].transforms[0]
        self.assertEqual(transform.header.frame_id, "world")
        self.assertEqual(transform.child_frame_id, "object")

    def test_it_waits_for_the_listener(self):
        self.move_to(-0.05)
        self.assertTrue(self.step_until(lambda: self.x() < -0.001))
        stamp = self.answer()
        ahead = self.wrenches.wait_for(
            lambda message: (message.header.stamp - stamp).to_sec() > (LAG + 1.5) * PERIOD, 1.0
        )
        self.assertIsNone(ahead, "it ran on without an answer")

    def test_clock_and_joint_states_go_with_the_samples(self):
        self.move_to(-0.05)
        self.assertTrue(self.step_until(lambda: self.x() < -0.01))
        state = None
        while state is None:
            stamp = self.answer()
            state = self.joints.wait_for(lambda message: message.header.stamp >= stamp, 0.1)
        self.assertEqual(state.name, JOINTS)
        self.assertLess(state.position[0], 0.0)
        clock = None
        while clock is None:
            stamp = self.answer()
            clock = self.clock.wait_for(lambda _: True, 0.1)
        self.assertLess(abs((clock.clock - stamp).to_sec()), 0.05)

    def test_a_command_moves_the_object_at_the_scenarios_speed(self):
        begin = self.answer()
        self.move_to(-0.05)
        near = 1e-4
        self.assertTrue(self.step_until(lambda: abs(self.x() + 0.05) < near))
        took = (self.answer() - begin).to_sec()
        self.assertGreater(took, (0.05 - near) / 0.2)
        self.assertLess(took, 1.0)

    def test_a_new_contact_stops_it_and_an_old_one_does_not(self):
        self.move_to(-0.05)
        self.assertTrue(self.step_until(lambda: self.x() < -0.01))
        type(self).contact_id += 1
        self.answer(ContactObservation.CONTACT)
        for _ in range(3 * LAG):
            self.answer(ContactObservation.CONTACT)
        stopped = self.x()
        for _ in range(50):
            self.answer(ContactObservation.CONTACT)
        self.assertLess(abs(self.x() - stopped), 1e-6)
        self.assertGreater(self.x(), -0.03)
        self.move_to(0.0)  # in the same contact: backing off is allowed
        self.assertTrue(self.step_until(lambda: abs(self.x()) < 1e-4))

    def test_an_empty_command_stops_it(self):
        self.move_to(-0.05)
        self.assertTrue(self.step_until(lambda: self.x() < -0.01))
        self.command.publish(JointTrajectory())
        for _ in range(50):
            self.answer()
        stopped = self.x()
        for _ in range(50):
            self.answer()
        self.assertEqual(self.x(), stopped)

    def test_bad_commands_are_refused(self):
        self.move_to(-0.05, joints=["elbow"] + JOINTS[1:])
        self.move_to(float("nan"))
        for _ in range(100):
            self.answer()
        self.assertEqual(self.x(), 0.0)

    def test_the_scene_is_shown(self):
        scene = Recorder("scene", MarkerArray).wait_for(lambda _: True)
        self.assertEqual([marker.header.frame_id for marker in scene.markers], ["world", "object"])


if __name__ == "__main__":
    rostest.rosrun("smore", "simulator_node_test", SimulatorNode)
