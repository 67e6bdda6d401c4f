#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""robot.launch as it is, on the twin of a UR5e's driver with its ramp and 10 ms latency each way."""

import math
import unittest
import xml.etree.ElementTree

import actionlib
import rospy
import rostest
from geometry_msgs.msg import WrenchStamped
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger
from tf2_msgs.msg import TFMessage
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from action_clients import has_ended
from node_killing import MOVES, STANDS, speed
from node_testing import DEADLINE, Recorder, start_node, wait_until
from smore.msg import ContactObservation, RetrieveAction, RetrieveGoal

CONTACT_FORCE = 5.0  # [N]
HAS_BACKED_OFF = 0.02  # of the 0.05 that a retreat goes [m]
MOST_FORCE = 25.0  # of a touch at 0.05 m/s [N]
# From the sample that confirms a contact to rest [m]: 1 mm for 10 ms of latency each way, 0.5 mm for the brake, and again so
# much for a busy processor.
MOST_WAY = 3e-3
# After a fault a piece of the motion may still be on its way to the controller, which drops it as long as it does not run:
# nobody is so quick to start it [s].
ON_ITS_WAY = 0.1
HERE = 5e-3  # a joint that has moved by less has not been commanded [rad]


def distance(a, b):
    p, q = a.pose.position, b.pose.position
    return math.dist((p.x, p.y, p.z), (q.x, q.y, q.z))


def force(message):
    f = message.wrench.force
    return (f.x, f.y, f.z)


class RobotTwin(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("robot_twin_test")
        cls.joints = Recorder("/joint_states", JointState)
        cls.wrenches = Recorder("/wrench", WrenchStamped)
        cls.contacts = Recorder("contact", ContactObservation)
        cls.faults = Recorder("guard/fault", String)
        cls.client = actionlib.SimpleActionClient("retrieve", RetrieveAction)
        assert cls.client.wait_for_server(rospy.Duration(DEADLINE))
        cls.reset_maps = rospy.ServiceProxy("reset", Trigger)
        cls.stop = rospy.ServiceProxy("stop", Trigger)
        cls.clear = rospy.ServiceProxy("guard/clear", Trigger)
        cls.play = rospy.ServiceProxy("robot_twin/play", Trigger)
        cls.cut = rospy.ServiceProxy("robot_twin/cut_network", SetBool)
        cls.run_controller = rospy.ServiceProxy("robot_twin/run_controller", SetBool)

    def test_rviz_can_draw_the_robot_of_the_description(self):
        robot = xml.etree.ElementTree.fromstring(rospy.get_param("/robot_description"))
        links = {link.get("name") for link in robot.findall("link")}
        self.assertGreater(len(robot.findall("link/visual")), 6)
        told = lambda message: links <= {transform.child_frame_id for transform in message.transforms}
        self.assertTrue(Recorder("/tf", TFMessage).wait_for(told), links)

    def begin_motion(self):
        self.joints.clear()
        self.client.send_goal(RetrieveGoal())
        self.assertIsNotNone(self.joints.wait_for(lambda m: speed(m) > MOVES), "no motion")
        self.faults.clear()

    def ends_with(self, words):
        self.assertIsNotNone(self.faults.wait_for(lambda m: words in m.data), "no fault")
        self.assertTrue(has_ended(self.client))
        self.assertIn("the guard has stopped the robot", self.client.get_result().message)
        self.let_pass(ON_ITS_WAY)

    def let_pass(self, duration):
        """Waits for `duration` [s] of the driver's time, from its newest sample on; returns the first and the last of
        the samples in it."""
        self.joints.clear()
        first = self.joints.wait_for(lambda m: True)
        end = first.header.stamp + rospy.Duration.from_sec(duration)
        return first, self.joints.wait_for(lambda m: m.header.stamp > end)

    def stays(self):
        """Whether the arm, once it stands, is there half a second later: what is frozen may still
        be on its way."""
        self.joints.clear()
        self.assertIsNotNone(self.joints.wait_for(lambda m: speed(m) < STANDS), "it does not stand")
        first, last = self.let_pass(0.5)
        return max(abs(b - a) for a, b in zip(first.position, last.position)) < HERE

    def go_on(self):
        self.assertTrue(self.play().success)
        self.assertTrue(self.stays(), "it moves after Play")
        self.assertTrue(wait_until(lambda: self.clear().success))
        self.assertTrue(self.stays(), "it moves after the clearing")

    def test_a_cut_network_stops_and_nothing_moves_before_a_new_goal(self):
        self.begin_motion()
        self.addCleanup(self.cut, False)
        self.assertTrue(self.cut(True).success)
        self.ends_with("the contact observations are late")
        self.assertTrue(self.cut(False).success)
        self.go_on()

    def test_a_cut_network_is_a_fault_at_rest_too(self):
        # A stream that has not begun cannot fall silent: as soon as the guard knows the contact observations.
        self.assertTrue(wait_until(self.a_cut_is_a_fault), "no fault")
        self.go_on()

    def a_cut_is_a_fault(self):
        self.faults.clear()
        self.assertTrue(self.cut(True).success)
        seen = self.faults.wait_for(lambda m: "are late" in m.data, 2.0) is not None
        self.assertTrue(self.cut(False).success)
        return seen

    def test_a_halt_of_the_robot_latches_and_nothing_moves_before_a_new_goal(self):
        for service, words in (("protective_stop", "safety mode is 3 (protective stop)"),
                               ("emergency_stop", "safety mode is 7 (robot emergency stop)"),
                               ("end_program", "the robot's program does not run")):
            with self.subTest(service):
                self.begin_motion()
                self.assertTrue(rospy.ServiceProxy("robot_twin/" + service, Trigger)().success)
                self.ends_with(words)
                self.assertFalse(self.clear().success, "cleared while the robot does not let it move")
                self.go_on()

    def send_goal(self, goal):
        """Returns the list that its phases will be in."""
        phases = []
        self.client.send_goal(goal, feedback_cb=lambda message: phases.append(message.phase))
        return phases

    def forget(self):
        """What has been touched is touched again."""
        self.assertTrue(self.reset_maps().success)

    def touch(self):
        """Sends a goal; the first observation of its first contact once it moves."""
        self.forget()
        phases = self.send_goal(RetrieveGoal())
        self.assertTrue(wait_until(lambda: "moving" in phases), "it does not move")
        self.contacts.clear()
        first = self.contacts.wait_for(lambda m: m.state == ContactObservation.CONTACT)
        self.assertIsNotNone(first, "it touches nothing")
        return first

    def test_a_cancel_in_contact_is_followed_by_a_way_back(self):
        self.touch()
        self.client.cancel_goal()
        self.assertTrue(has_ended(self.client))
        self.contacts.clear()
        # How far it went does not matter: what touched while the robot braked already may press no more by itself.
        free = lambda m: m.state == ContactObservation.FREE
        self.assertIsNotNone(self.contacts.wait_for(free), "it stays where it presses")

    def test_a_goal_that_comes_while_it_backs_off_takes_over(self):
        self.touch()
        self.client.cancel_goal()
        self.assertTrue(has_ended(self.client))
        # The maps learn a contact from its line, which comes with its end at the latest.
        self.assertIsNotNone(self.contacts.wait_for(lambda m: m.has_line), "no line")
        self.forget()
        self.client.send_goal(RetrieveGoal(max_collisions=1))
        self.assertTrue(has_ended(self.client, 2 * DEADLINE))
        self.assertEqual(self.client.get_result().message, "reached the limit of 1 collisions")

    def stopped_in_contact(self):
        """Touches and stops; the contact's first observation, None where a busy processor let it retreat first, if only
        by the tenth of a millimetre that a rigid peg takes to let go."""
        first = self.touch()
        self.assertTrue(self.stop().success)
        self.assertTrue(has_ended(self.client))
        told = "may still press" in self.client.get_result().message
        self.assertTrue(self.stays(), "it moves after the stop")
        return first if told and self.contacts.messages()[-1].state == ContactObservation.CONTACT else None

    def test_a_stop_in_contact_moves_nothing_and_the_next_goal_backs_off_before_it_zeroes(self):
        stopped = []
        self.assertTrue(wait_until(lambda: stopped.append(self.stopped_in_contact()) or stopped[-1]))
        first = stopped[-1]
        phases = self.send_goal(RetrieveGoal(max_collisions=1))
        self.assertTrue(wait_until(lambda: "planning" in phases), "no next goal")
        self.assertGreater(distance(first, self.contacts.messages()[-1]), HAS_BACKED_OFF)
        self.assertLess(math.hypot(*force(self.wrenches.messages()[-1])), CONTACT_FORCE)
        self.client.cancel_goal()
        self.assertTrue(has_ended(self.client))

    def moved_by_somebody_else(self, positions):
        """Sends the arm to these joint positions past guard and retrieval, as a pendant would. The guard's reflex ends
        the first of these motions: what is free feels like a contact where the sensor was zeroed under a press."""
        command = rospy.Publisher("/scaled_pos_joint_traj_controller/command", JointTrajectory, queue_size=1)
        self.addCleanup(command.unregister)
        self.assertTrue(wait_until(lambda: command.get_num_connections() > 0))
        end = JointTrajectoryPoint(positions=positions, velocities=[0.0] * len(positions))
        end.time_from_start = rospy.Duration(2.0)
        motion = JointTrajectory(joint_names=self.joints.messages()[-1].name, points=[end])
        there = lambda m: all(abs(a - b) < HERE for a, b in zip(m.position, positions))
        arrives = lambda: command.publish(motion) or self.joints.wait_for(there, 4.0) is not None
        self.assertTrue(wait_until(arrives), "it does not go there")

    def test_a_program_that_is_started_under_a_press_moves_nothing_until_the_object_is_free(self):
        self.joints.clear()
        start = self.joints.wait_for(lambda m: True).position
        self.assertTrue(wait_until(self.stopped_in_contact))
        self.assertTrue(rospy.ServiceProxy("robot_twin/protective_stop", Trigger)().success)
        self.assertIsNotNone(self.faults.wait_for(lambda m: "protective stop" in m.data), "no fault")
        self.go_on()
        self.joints.clear()
        self.client.send_goal(RetrieveGoal())
        self.assertTrue(has_ended(self.client))
        self.assertIn("was started while the object pressed", self.client.get_result().message)
        self.assertLess(max(speed(m) for m in self.joints.messages()), STANDS)
        self.moved_by_somebody_else(start)
        self.assertTrue(rospy.ServiceProxy("/ur_hardware_interface/zero_ftsensor", Trigger)().success)
        phases = self.send_goal(RetrieveGoal())
        self.assertTrue(wait_until(lambda: "planning" in phases), "no goal once the object is free")
        self.client.cancel_goal()
        self.assertTrue(has_ended(self.client))

    def test_a_stopped_controller_is_named_before_anything_moves(self):
        self.addCleanup(self.run_controller, True)
        self.assertTrue(self.run_controller(False).success)
        self.joints.clear()
        self.faults.clear()
        self.client.send_goal(RetrieveGoal())
        self.ends_with("is loaded but does not run")
        self.assertLess(max(speed(m) for m in self.joints.messages()), STANDS)
        self.assertTrue(self.run_controller(True).success)
        self.go_on()

    def test_a_touch_stops_softly(self):
        # The guard of a processor that is too busy stops a motion before it touches.
        touches = []
        self.assertTrue(wait_until(lambda: touches or touches.extend(self.retrieve_and_touch()), 2 * DEADLINE))
        for peak, way in touches:
            print("peak force %.1f N, %.1f mm after the confirming sample" % (peak, 1e3 * way))
        # A processor that is busy is late now and then, the chain as it is every time.
        self.assertLess(min(peak for peak, _ in touches), MOST_FORCE)
        self.assertLess(min(way for _, way in touches), MOST_WAY)

    def retrieve_and_touch(self):
        self.clear()
        self.forget()
        self.wrenches.clear()
        self.contacts.clear()
        self.client.send_goal(RetrieveGoal(max_collisions=3))
        self.assertTrue(has_ended(self.client, 2 * DEADLINE))
        return self.touches()

    def touches(self):
        """Peak force [N] and way [m] of each, from its confirming sample to its line, which is given once the wrench stands."""
        wrenches = self.wrenches.messages()
        contacts = self.contacts.messages()
        first = {m.contact_id: m for m in reversed(contacts) if m.state == m.CONTACT}
        if not first:
            return []
        free = [w for w in wrenches if w.header.stamp < first[min(first)].header.stamp]
        rest = force(free[-len(free) // 10])
        result = []
        for line in [m for m in contacts if m.has_line and m.contact_id in first]:
            begin = first[line.contact_id]
            pressed = [w for w in wrenches if begin.header.stamp <= w.header.stamp <= line.header.stamp]
            peak = max(math.dist(force(w), rest) for w in pressed)
            result.append((peak, distance(begin, line)))
        return result


if __name__ == "__main__":
    rostest.rosrun("smore", "robot_twin_test", RobotTwin)
