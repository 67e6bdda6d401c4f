#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The guard alone, between generated commands and a generated driver."""

import threading
import unittest

import rospy
import rostest
from geometry_msgs.msg import WrenchStamped
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from std_srvs.srv import Trigger
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from node_testing import DEADLINE, Recorder, start_node, wait_until

JOINTS = [
    "shoulder_pan_joint",
    "shoulder_lift_joint",
    "elbow_joint",
    "wrist_1_joint",
    "wrist_2_joint",
    "wrist_3_joint",
]
PERIOD = 0.01  # of both streams [s]


class Driver:
    """A robot at rest that says so, until it is told to be silent or to feel something."""

    def __init__(self):
        self.force = 0.0  # [N]
        self.felt = 0  # wrenches that the guard was there to receive
        self.wrenches = self.joints = True
        self._wrench = rospy.Publisher("wrench", WrenchStamped, queue_size=1, tcp_nodelay=True)
        self._joints = rospy.Publisher("joint_states", JointState, queue_size=1, tcp_nodelay=True)
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self):
        while not self._end.wait(PERIOD):
            if self.wrenches:
                wrench = WrenchStamped()
                wrench.header.stamp = rospy.Time.now()
                wrench.wrench.force.z = self.force
                self._wrench.publish(wrench)
                self.felt += self._wrench.get_num_connections() > 0
            if self.joints:
                joints = JointState(name=JOINTS, position=[0.0] * 6, velocity=[0.0] * 6)
                joints.header.stamp = rospy.Time.now()
                self._joints.publish(joints)

    def close(self):
        self._end.set()
        self._thread.join()


def motion(start=0.0):
    """One radian in two seconds, all joints from `start` [rad]."""
    message = JointTrajectory(joint_names=JOINTS)
    for time, position in ((0.0, start), (2.0, start + 1.0)):
        message.points.append(
            JointTrajectoryPoint(
                positions=[position] * 6,
                velocities=[0.0] * 6,
                time_from_start=rospy.Duration.from_sec(time),
            )
        )
    return message


class GuardNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("guard_node_test")
        cls.passed = Recorder("guarded_command", JointTrajectory)
        cls.faults = Recorder("guard/fault", String)
        cls.log = Recorder("/rosout", Log)
        cls.command = rospy.Publisher("command", JointTrajectory, queue_size=10, tcp_nodelay=True)
        for name in ("guard/clear", "guard/stop"):
            rospy.wait_for_service(name, DEADLINE)
        cls.clear = rospy.ServiceProxy("guard/clear", Trigger)
        cls.stop = rospy.ServiceProxy("guard/stop", Trigger)
        assert cls.passed.wait_for_publisher() and cls.log.wait_for_publisher()
        assert wait_until(lambda: cls.command.get_num_connections() > 0)

    def setUp(self):
        self.driver = Driver()
        self.addCleanup(self.driver.close)
        # The force of the test before would count as the load that a clearing begins under.
        self.assertTrue(wait_until(lambda: self.driver.felt > 20))
        self.assertTrue(wait_until(lambda: self.clear().success), "a fault of a healthy robot")
        # The guard knows where the joints are as soon as it lets a motion pass.
        self.assertTrue(wait_until(self.moves))
        self.passed.clear()
        self.faults.clear()

    def moves(self):
        self.clear()
        self.passed.clear()
        self.command.publish(motion())
        return self.passed.wait_for(lambda message: message.points, 1.0) is not None

    def stopped_because(self, words):
        self.assertTrue(self.passed.wait_for(lambda message: not message.points), "no stop")
        self.assertTrue(self.faults.wait_for(lambda message: words in message.data), words)
        self.passed.clear()
        self.log.clear()
        self.command.publish(motion())
        self.assertTrue(self.log.wait_for(lambda message: "command refused" in message.msg))
        self.command.publish(JointTrajectory())
        # What passes keeps its order: nothing but the stop came through.
        self.assertTrue(self.passed.wait_for(lambda message: not message.points))
        self.assertFalse([message for message in self.passed.messages() if message.points])

    def test_a_proper_motion_passes_as_it_is(self):
        self.command.publish(motion())
        self.assertEqual(self.passed.wait_for(lambda message: True).points, motion().points)

    def test_a_force_above_the_ceiling_stops_until_it_is_cleared(self):
        self.driver.force = 45.0
        self.stopped_because("the force is 45 N")
        self.driver.force = 0.0
        self.assertTrue(self.clear().success)
        self.assertTrue(self.faults.wait_for(lambda message: message.data == ""))
        self.assertTrue(self.moves())

    def test_after_a_clearing_it_may_retreat_under_load(self):
        self.driver.force = 45.0
        self.stopped_because("the force is 45 N")
        self.assertTrue(self.clear().success)
        self.passed.clear()
        self.command.publish(motion())
        self.assertTrue(self.passed.wait_for(lambda message: message.points), "no retreat")

    def test_silence_of_the_wrench_stops_and_is_not_cleared_while_it_lasts(self):
        self.driver.wrenches = False
        self.stopped_because("no new wrench")
        refused = self.clear()
        self.assertFalse(refused.success)
        self.assertIn("no new wrench", refused.message)
        self.driver.wrenches = True
        self.assertTrue(wait_until(lambda: self.clear().success))

    def test_silence_of_the_joint_states_stops(self):
        self.driver.joints = False
        self.stopped_because("no new joint states")

    def test_a_motion_from_where_the_arm_is_not_stops(self):
        self.command.publish(motion(start=0.5))
        self.stopped_because("from the commanded start")

    def test_the_user_can_stop(self):
        self.assertTrue(self.stop().success)
        self.stopped_because("stopped by the user")


if __name__ == "__main__":
    rostest.rosrun("smore", "guard_node_test", GuardNode)
