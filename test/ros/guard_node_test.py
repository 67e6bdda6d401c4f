#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The guard alone, between generated commands and a generated driver."""

import os
import signal
import unittest

import rospy
import rostest
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64, String
from std_srvs.srv import Trigger
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from guarded_driver import JOINTS, PERIOD, Driver
from node_killing import CALLER, api_of
from node_testing import DEADLINE, Recorder, start_node, wait_until

LISTENS = round(0.3 / PERIOD)  # wrenches: longer than four tenths of the max_lateness here
HELD_UP = round(2.2 / PERIOD)  # wrenches, during which the guard is: its max_silence is 2 s here


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


def is_stop(message):
    """A brake is one point; a stop without points is for joints of which nothing is known."""
    return len(message.points) <= 1


def is_horizon(message):
    return len(message.points) > 1


class GuardNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("guard_node_test")
        cls.passed = Recorder("guarded_command", JointTrajectory)
        cls.faults = Recorder("guard/fault", String)
        cls.log = Recorder("/rosout", Log)
        cls.command = rospy.Publisher("command", JointTrajectory, queue_size=10, tcp_nodelay=True)
        cls.scaling = rospy.Publisher("speed_scaling_factor", Float64, queue_size=1, latch=True)
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
        # The guard knows all streams as soon as it lets a motion pass.
        self.assertTrue(wait_until(self.moves))
        self.end_motion()

    def end_motion(self):
        self.command.publish(JointTrajectory())
        self.assertTrue(self.passed.wait_for(is_stop), "no stop")
        self.passed.clear()
        self.faults.clear()

    def moves(self):
        """Whether a motion begins; it goes on."""
        self.clear()
        self.passed.clear()
        self.command.publish(motion(self.driver.position))
        return self.passed.wait_for(is_horizon, 1.0) is not None

    def stopped_because(self, words):
        self.assertTrue(self.faults.wait_for(lambda message: words in message.data), words)
        self.passed.clear()
        self.log.clear()
        self.command.publish(motion(self.driver.position))
        self.assertTrue(self.log.wait_for(lambda message: "command refused" in message.msg))
        self.command.publish(JointTrajectory())
        # What passes keeps its order: nothing but the stop came through.
        self.assertTrue(self.passed.wait_for(is_stop))
        self.assertFalse([m for m in self.passed.messages() if is_horizon(m)])

    def test_a_motion_passes_in_short_pieces_that_end_at_rest(self):
        begin = self.driver.position
        self.assertTrue(self.moves())
        there = lambda message: message.points[-1].positions[0] > begin + 0.2
        self.assertTrue(self.passed.wait_for(there), "the motion does not go on")
        for piece in self.passed.messages():
            self.assertEqual(piece.joint_names, JOINTS)
            self.assertGreater(piece.points[0].time_from_start.to_sec(), 0.0)
            self.assertLessEqual(piece.points[-1].time_from_start.to_sec(), 0.25)
            self.assertEqual(list(piece.points[-1].velocities), [0.0] * 6)
        self.end_motion()

    def test_a_new_contact_stops_the_motion_and_is_no_fault(self):
        self.assertTrue(self.moves())
        self.driver.contact_id = 1
        self.assertTrue(self.passed.wait_for(is_stop), "no stop")
        self.passed.clear()
        self.assertIsNone(self.passed.wait_for(is_horizon, 0.2), "it goes on")
        self.assertFalse([m for m in self.faults.messages() if m.data])
        self.assertTrue(self.moves(), "no way out of the contact")
        self.end_motion()

    def test_a_motion_that_nobody_attends_to_is_stopped(self):
        self.assertTrue(self.moves())
        self.driver.attended = False
        self.stopped_because("no sign of life")

    def test_a_motion_without_contact_observations_is_stopped(self):
        self.assertTrue(self.moves())
        self.driver.contacts = False
        self.stopped_because("the contact observations are late")

    def test_a_motion_waits_for_what_is_late_and_goes_on(self):
        self.assertTrue(self.moves())
        self.driver.contacts = False
        self.assertTrue(self.passed.wait_for(is_stop), "no brake")
        self.assertTrue(wait_until(lambda: not self.pieces_in(0.1)), "it goes on blindly")
        self.driver.contacts = True
        self.passed.clear()
        self.assertTrue(self.passed.wait_for(is_horizon), "it does not go on")
        self.assertFalse([m for m in self.faults.messages() if m.data])
        self.end_motion()

    def test_a_motion_whose_joints_were_late_goes_on_where_the_robot_has_come(self):
        begin = self.driver.position
        self.assertTrue(self.moves())
        there = lambda message: message.points[-1].positions[0] > begin + 0.3
        self.assertTrue(self.passed.wait_for(there), "the motion does not go on")
        self.driver.joints = False
        # Longer than its max_lateness; the robot goes on to the end of what it was told meanwhile.
        self.assertTrue(wait_until(lambda: not self.pieces_in(0.5)))
        first, last = (self.driver.horizon.points[i].positions[0] for i in (0, -1))
        self.driver.position = last
        self.passed.clear()
        self.driver.joints = True
        piece = self.passed.wait_for(is_horizon)
        self.assertIsNotNone(piece, "it does not go on")
        self.assertGreater(piece.points[0].positions[0], 0.5 * (first + last), "it is thrown back")
        self.assertFalse([m for m in self.faults.messages() if m.data])
        self.end_motion()

    def test_a_paused_robot_gets_nothing_and_goes_on_later(self):
        self.assertTrue(self.moves())
        self.scaling.publish(0.0)
        self.addCleanup(self.scaling.publish, 1.0)
        self.assertTrue(wait_until(lambda: not self.pieces_in(0.2)), "it goes on")
        self.scaling.publish(1.0)
        self.passed.clear()
        self.assertTrue(self.passed.wait_for(is_horizon), "it does not go on")
        self.end_motion()

    def pieces_in(self, duration):
        self.passed.clear()
        return self.passed.wait_for(is_horizon, duration) is not None

    def test_a_force_above_the_ceiling_stops_until_it_is_cleared(self):
        self.driver.force = 45.0
        self.stopped_because("the force is 45 N")
        self.driver.force = 0.0
        self.assertTrue(self.clear().success)
        self.assertTrue(self.faults.wait_for(lambda message: message.data == ""))
        self.assertTrue(self.moves())
        self.end_motion()

    def test_after_a_clearing_it_may_retreat_under_load(self):
        self.driver.force = 45.0
        self.stopped_because("the force is 45 N")
        self.assertTrue(self.clear().success)
        self.assertTrue(self.moves(), "no retreat")
        self.end_motion()

    def test_silence_of_the_wrench_stops_and_is_not_cleared_while_it_lasts(self):
        self.driver.wrenches = False
        self.stopped_because("no wrench younger")
        refused = self.clear()
        self.assertFalse(refused.success)
        self.assertIn("no wrench younger", refused.message)
        self.driver.wrenches = True
        self.assertTrue(wait_until(lambda: self.clear().success))

    def test_silence_of_the_joint_states_stops(self):
        self.driver.joints = False
        self.stopped_because("no joint states younger")

    def test_a_wrench_that_never_changes_is_a_fault_at_rest(self):
        self.driver.noise = 0.0
        self.stopped_because("the wrench has been the same")

    def test_stamps_of_long_ago_are_a_fault_at_rest(self):
        self.driver.age = 5.0  # of both streams, in whichever order they are sent
        self.stopped_because("younger than")

    def hold_up_the_guard(self):
        """Longer than any stream may be silent; not again before it has listened for a while."""
        _, _, guard = api_of("guard").getPid(CALLER)
        self.driver_sends(LISTENS)
        os.kill(guard, signal.SIGSTOP)
        try:
            self.driver_sends(HELD_UP)
        finally:
            os.kill(guard, signal.SIGCONT)

    def driver_sends(self, wrenches):
        until = self.driver.felt + wrenches
        self.assertTrue(wait_until(lambda: self.driver.felt > until))

    def test_that_the_guard_was_held_up_is_no_silence(self):
        for _ in range(3):  # which stream it hears first is chance
            self.hold_up_the_guard()
            self.command.publish(motion(self.driver.position))
            self.assertTrue(self.passed.wait_for(is_horizon), "no motion begins")
            self.assertFalse([m.data for m in self.faults.messages() if m.data])
            self.end_motion()

    def test_contact_observations_that_stay_out_are_a_fault_at_rest(self):
        self.driver.contacts = False
        self.stopped_because("the contact observations are late")

    def test_a_motion_from_where_the_arm_is_not_stops(self):
        self.command.publish(motion(start=self.driver.position + 0.5))
        self.stopped_because("from the commanded start")

    def test_a_controller_that_is_missing_is_named(self):
        self.driver.stop_listening()
        self.passed.close()
        self.addCleanup(self.listen_again)
        nobody = lambda message: "nobody listens to commands on" in message.data
        self.assertTrue(wait_until(lambda: self.fault_of_a_motion(nobody)))

    def fault_of_a_motion(self, condition):
        self.command.publish(motion(self.driver.position))
        return self.faults.wait_for(condition, 0.1)

    @classmethod
    def listen_again(cls):
        cls.passed = Recorder("guarded_command", JointTrajectory)
        assert cls.passed.wait_for_publisher()

    def test_a_controller_that_has_a_state_and_does_not_tell_it_is_named(self):
        state = rospy.Publisher("controller_state", JointState, queue_size=1)
        self.addCleanup(state.unregister)
        self.assertTrue(wait_until(lambda: state.get_num_connections() > 0))
        silent = lambda message: "is loaded but does not run" in message.data
        self.assertTrue(wait_until(lambda: self.fault_of_a_motion(silent)))

        def moves_while_it_tells():
            state.publish(JointState())
            return self.moves()

        self.assertTrue(wait_until(moves_while_it_tells))

    def test_the_user_can_stop(self):
        self.assertTrue(self.stop().success)
        self.stopped_because("stopped by the user")


if __name__ == "__main__":
    rostest.rosrun("smore", "guard_node_test", GuardNode)
