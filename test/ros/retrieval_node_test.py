#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The retrieval alone; the test plays sensor, robot and planner."""

import threading
import time
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from nav_msgs.msg import Path
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from std_srvs.srv import Trigger
from trajectory_msgs.msg import JointTrajectory

from action_clients import has_arrived, has_ended
from node_testing import Recorder, pose, stamped, start_node, wait_until
from observations import ObservationSource
from smore.msg import ContactObservation, RetrieveAction, RetrieveGoal
from smore.srv import PlanPath, PlanPathResponse

DEADLINE = rospy.Duration(30.0)
JOINTS = ["x_joint", "y_joint", "z_joint", "yaw_joint", "pitch_joint", "roll_joint"]


class FakeArm:
    """Publishes observations as fast as they are taken and follows commands, a step at a time."""

    time = 1.0  # of the last one [s]: stamps never go back, or joint states of the arm before would count

    def __init__(self):
        self.source = ObservationSource(FakeArm.time + 1.0)
        self.target = None
        self.x = 0.0
        self.height = 0.0  # of the object above the plane of motion [m]
        self.state = ContactObservation.FREE
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._joints = rospy.Publisher("joint_states", JointState, queue_size=10)
        self._command = rospy.Subscriber("command", JointTrajectory, self._follow)

    def _follow(self, message):
        self.target = message.points[-1].positions[0] if message.points else self.x

    def _run(self):
        while not self._stop.wait(0.0005):
            if self.target is not None:
                step = max(-0.0004, min(0.0004, self.target - self.x))  # 0.2 m/s
                self.x += step
            observation = self.source.next(self.state, self.x)
            observation.pose.position.z = self.height
            joints = JointState(name=JOINTS, position=[self.x, 0, 0, 0, 0, 0])
            joints.header.stamp = observation.header.stamp
            self._joints.publish(joints)
            self.source.publish(observation)

    def feel_for(self, duration):
        """Waits until so many more seconds have been observed."""
        end = self.source.time + duration
        assert wait_until(lambda: self.source.time > end)

    def __enter__(self):
        assert self.source.wait_for_listener()
        assert wait_until(lambda: self._joints.get_num_connections() > 0)
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._stop.set()
        self._thread.join()
        FakeArm.time = self.source.time
        self._command.unregister()
        self._joints.unregister()


class RetrievalNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("retrieval_node_test")
        cls.client = actionlib.SimpleActionClient("retrieve", RetrieveAction)
        assert cls.client.wait_for_server(DEADLINE)
        cls.refusal, cls.searched = "", True
        cls.may_answer = threading.Event()
        cls.may_answer.set()
        cls.requests = []
        cls.planner = rospy.Service("plan_path", PlanPath, cls.plan)
        # Before any other test, whose last observations might still be on their way.
        cls.client.send_goal(RetrieveGoal())
        assert has_ended(cls.client)
        cls.without_sensor = cls.client.get_result()

    @classmethod
    def plan(cls, request):
        cls.requests.append(request)
        cls.may_answer.wait()
        if cls.refusal:
            return PlanPathResponse(success=False, searched=cls.searched, message=cls.refusal)
        path = Path()
        path.poses = [request.start, request.goal]
        return PlanPathResponse(success=True, path=path, risk=0.25)

    def setUp(self):
        type(self).refusal, type(self).searched = "", True
        self.may_answer.set()
        self.requests.clear()
        self.commands = Recorder("command", JointTrajectory)
        self.addCleanup(self.commands.close)
        self.assertTrue(self.commands.wait_for_publisher())

    def retrieve(self, goal=None):
        self.client.send_goal(goal or RetrieveGoal())
        self.assertTrue(has_ended(self.client))
        return self.client.get_result()

    def test_without_a_sensor_it_says_what_is_missing(self):
        self.assertFalse(self.without_sensor.success)
        self.assertIn("no contact observations", self.without_sensor.message)

    def test_it_moves_along_the_plan_to_the_goal(self):
        with FakeArm() as arm:
            result = self.retrieve()
            self.assertTrue(result.success, result.message)
            self.assertAlmostEqual(arm.x, -0.3, 3)
        self.assertEqual(result.collisions, 0)
        self.assertEqual(result.plans, 1)
        self.assertAlmostEqual(result.path_length, 0.3, 2)

    def test_a_fault_of_the_guard_ends_it_at_once_with_its_reason(self):
        guard = rospy.Publisher("guard/fault", String, queue_size=1, latch=True)
        guard.publish("the force is 45 N")
        with FakeArm():
            result = self.retrieve()
            guard.publish("")
            again = wait_until(lambda: self.retrieve().success)
        self.assertFalse(result.success)
        self.assertIn("the force is 45 N", result.message)
        self.assertTrue(again)

    def test_a_fault_that_came_and_was_cleared_while_it_plans_ends_it_too(self):
        guard = rospy.Publisher("guard/fault", String, queue_size=5, latch=True)
        self.addCleanup(guard.unregister)
        self.assertTrue(wait_until(lambda: guard.get_num_connections() > 0))
        self.may_answer.clear()
        with FakeArm() as arm:
            self.client.send_goal(RetrieveGoal())
            self.assertTrue(wait_until(lambda: self.requests))
            guard.publish("somebody pressed the stop")
            arm.feel_for(1.0)  # it has come by then: a publisher of rospy may keep the newest alone
            guard.publish("")
            arm.feel_for(1.0)
            self.may_answer.set()
            self.assertTrue(has_ended(self.client))
            result = self.client.get_result()
            self.assertTrue(self.never_moved(), result.message)
            again = self.retrieve()
        self.assertFalse(result.success)
        self.assertIn("somebody pressed the stop", result.message)
        self.assertTrue(again.success, again.message)

    def test_where_no_plan_is_found_an_arm_that_was_led_away_does_not_go_back_to_its_old_way(self):
        with FakeArm() as arm:
            self.cancel_on_the_way(arm)
            arm.target = None
            arm.x = 0.1
            type(self).refusal = "the start is outside of the workspace"
            self.assert_stays_without_a_plan()

    def test_where_the_planner_cannot_be_asked_an_arm_stays_on_its_way(self):
        with FakeArm() as arm:
            self.cancel_on_the_way(arm)
            type(self).refusal, type(self).searched = "the mapping does not answer", False
            self.assert_stays_without_a_plan()

    def test_from_a_goal_that_was_reached_no_way_leads_back(self):
        with FakeArm():
            self.assertTrue(self.retrieve().success)
            type(self).refusal = "walled in"
            self.assert_stays_without_a_plan(RetrieveGoal(goal=stamped(pose(0.0))))

    def test_an_object_beside_the_plane_of_motion_is_not_moved(self):
        with FakeArm() as arm:
            arm.height = 0.3
            result = self.retrieve()
            self.assertFalse(result.success)
            self.assertIn("the object is 0.3 m and 0 rad beside the plane of motion", result.message)
            self.assertTrue(self.never_moved())
            arm.height = 0.001  # as an arm is never quite in it
            arm.feel_for(0.5)
            result = self.retrieve()
        self.assertTrue(result.success, result.message)

    def test_a_sensor_that_is_unsure_is_no_reason_to_back_off(self):
        with FakeArm() as arm:
            self.assertTrue(self.retrieve().success)
            arm.state = ContactObservation.UNSURE  # as it says while it is tared
            arm.feel_for(1.0)
            self.commands.clear()
            result = self.retrieve()
        self.assertFalse(result.success)
        self.assertIn("never says that the object is free", result.message)
        self.assertTrue(self.never_moved())

    def plan_while(self, arm, state, contacts):
        """A goal whose plan comes when the sensor has been in another state for a second."""
        self.phases = []
        self.may_answer.clear()
        self.client.send_goal(RetrieveGoal(), feedback_cb=lambda feedback: self.phases.append(feedback.phase))
        self.assertTrue(wait_until(lambda: self.requests))
        arm.source.contacts += contacts
        arm.state = state
        arm.feel_for(1.0)
        self.may_answer.set()

    def test_it_does_not_set_out_while_something_presses_that_came_while_it_planned(self):
        with FakeArm() as arm:
            self.plan_while(arm, ContactObservation.CONTACT, 1)
            self.assertTrue(wait_until(lambda: "retreating" in self.phases))
            self.assertTrue(self.never_moved())
            arm.state = ContactObservation.FREE
            self.assertTrue(has_ended(self.client))
            result = self.client.get_result()
        self.assertTrue(result.success, result.message)
        self.assertEqual(result.collisions, 1)

    def test_it_does_not_set_out_while_the_sensor_is_tared(self):
        with FakeArm() as arm:
            self.plan_while(arm, ContactObservation.UNSURE, 0)
            arm.feel_for(0.8)
            self.assertTrue(self.never_moved())
            arm.state = ContactObservation.FREE
            self.assertTrue(has_ended(self.client))
            self.assertTrue(self.client.get_result().success)

    def test_it_does_not_back_off_from_a_weight_that_was_gripped_at_the_goal(self):
        with FakeArm() as arm:
            self.assertTrue(self.retrieve().success)
            arm.feel_for(1.5)
            arm.source.contacts += 1
            arm.state = ContactObservation.CONTACT
            arm.feel_for(0.1)
            self.commands.clear()
            result = self.retrieve(RetrieveGoal(goal=stamped(pose(0.0))))
        self.assertFalse(result.success)
        self.assertIn("the object presses against something", result.message)
        self.assertTrue(self.never_moved())

    def test_it_asks_for_plans_on_maps_as_new_as_what_it_felt(self):
        with FakeArm():
            self.retrieve()
        self.assertGreater(self.requests[0].not_before, rospy.Time())

    def test_a_goal_of_the_callers_own_is_taken_in_the_world_frame_only(self):
        with FakeArm() as arm:
            self.assertTrue(self.retrieve(RetrieveGoal(goal=stamped(pose(-0.1)))).success)
            self.assertAlmostEqual(arm.x, -0.1, 3)
            result = self.retrieve(RetrieveGoal(goal=stamped(pose(-0.1), "base")))
        self.assertFalse(result.success)
        self.assertIn("'base'", result.message)

    def test_a_sensor_that_falls_silent_in_a_motion_is_a_fault_and_the_robot_is_stopped(self):
        commands = self.commands
        with FakeArm():
            self.client.send_goal(RetrieveGoal())
            self.assertIsNotNone(commands.wait_for(lambda message: message.points))
        self.assertTrue(has_ended(self.client))
        result = self.client.get_result()
        self.assertFalse(result.success)
        self.assertIn("no contact observation", result.message)
        self.assertIsNotNone(commands.wait_for(lambda message: not message.points), "no stop")

    def test_the_stop_service_ends_the_motion(self):
        commands = self.commands
        with FakeArm():
            self.client.send_goal(RetrieveGoal())
            self.assertIsNotNone(commands.wait_for(lambda message: message.points))
            self.assertTrue(rospy.ServiceProxy("stop", Trigger)().success)
            self.assertTrue(has_ended(self.client))
        self.assertIn("stopped by the user", self.client.get_result().message)
        self.assertIsNotNone(commands.wait_for(lambda message: not message.points), "no stop")

    def cancelled_within(self, seconds):
        begin = time.monotonic()
        self.client.cancel_goal()
        self.assertTrue(has_ended(self.client))
        self.assertLess(time.monotonic() - begin, seconds)
        self.assertEqual(self.client.get_state(), GoalStatus.PREEMPTED)
        self.assertIn("stopped by the user", self.client.get_result().message)

    def cancel_on_the_way(self, arm):
        self.client.send_goal(RetrieveGoal())
        self.assertTrue(wait_until(lambda: arm.x < -0.05))
        self.cancelled_within(0.4)

    def assert_stays_without_a_plan(self, goal=None):
        self.commands.clear()
        result = self.retrieve(goal)
        self.assertFalse(result.success)
        self.assertIn(self.refusal, result.message)
        self.assertTrue(self.never_moved(), result.message)

    def never_moved(self):
        return not [message for message in self.commands.messages() if message.points]

    def test_a_cancel_while_it_waits_for_the_sensor_is_answered_at_once(self):
        self.client.send_goal(RetrieveGoal())
        self.assertTrue(wait_until(lambda: self.client.get_state() == GoalStatus.ACTIVE))
        self.cancelled_within(0.4)
        self.assertTrue(self.never_moved())

    def test_a_cancel_while_it_plans_is_answered_at_once_and_nothing_moves(self):
        self.may_answer.clear()
        with FakeArm():
            self.client.send_goal(RetrieveGoal())
            self.assertTrue(wait_until(lambda: self.requests))
            self.cancelled_within(0.4)
            self.may_answer.set()
            again = self.retrieve(RetrieveGoal(goal=stamped(pose(0.0))))
        self.assertTrue(again.success, again.message)
        self.assertTrue(self.never_moved())

    def test_a_cancel_at_any_time_before_the_plan_has_come_is_told_as_one_and_nothing_moves(self):
        def is_active():
            return self.client.get_state() == GoalStatus.ACTIVE

        phases = [lambda: True, is_active, lambda: is_active() and self.requests]
        self.may_answer.clear()
        with FakeArm():
            for has_begun in phases * 5:
                self.requests.clear()
                self.client.send_goal(RetrieveGoal())
                self.assertTrue(wait_until(has_begun))
                self.client.cancel_goal()
                self.assertTrue(has_ended(self.client))
                # LOST: a status of the server's passed the goal on its way, and then the client gives it up.
                ends = (GoalStatus.PREEMPTED, GoalStatus.RECALLED, GoalStatus.LOST)
                self.assertIn(self.client.get_state(), ends)
            self.may_answer.set()  # the plans come now
            again = self.retrieve(RetrieveGoal(goal=stamped(pose(0.0))))
        self.assertTrue(again.success, again.message)
        self.assertTrue(self.never_moved())

    def test_a_cancel_in_motion_is_answered_at_once(self):
        with FakeArm():
            self.client.send_goal(RetrieveGoal())
            self.assertIsNotNone(self.commands.wait_for(lambda message: message.points))
            self.cancelled_within(0.4)

    def test_a_stop_just_after_a_goal_has_come_is_never_lost(self):
        stop = rospy.ServiceProxy("stop", Trigger)
        with FakeArm():
            for _ in range(20):
                self.client.send_goal(RetrieveGoal())
                self.assertTrue(has_arrived(self.client))
                self.assertTrue(stop().success)
                self.assertTrue(has_ended(self.client))
                self.assertIn("stopped by the user", self.client.get_result().message)

    def test_a_goal_cancelled_before_it_begins_never_moves(self):
        self.may_answer.clear()
        with FakeArm():
            self.client.send_goal(RetrieveGoal())
            self.assertTrue(wait_until(lambda: self.requests))
            other = actionlib.SimpleActionClient("retrieve", RetrieveAction)
            self.assertTrue(other.wait_for_server(DEADLINE))
            other.send_goal(RetrieveGoal())
            self.assertTrue(has_arrived(other))
            other.cancel_goal()
            self.assertTrue(has_ended(other))
            self.assertEqual(other.get_state(), GoalStatus.PREEMPTED)
            self.may_answer.set()
        self.assertTrue(self.never_moved())

    def test_a_goal_outside_of_the_workspace_is_refused_at_once(self):
        result = self.retrieve(RetrieveGoal(goal=stamped(pose(-5.0))))
        self.assertFalse(result.success)
        self.assertIn("the goal (-5 0 0) is outside of the workspace", result.message)
        self.assertFalse(self.requests)

    def test_an_object_at_the_goal_is_not_moved(self):
        with FakeArm():
            result = self.retrieve(RetrieveGoal(goal=stamped(pose(0.0))))
        self.assertTrue(result.success, result.message)
        self.assertFalse(self.requests)
        self.assertTrue(self.never_moved())

    def test_without_a_plan_it_gives_the_planners_reason(self):
        type(self).refusal = "the planner is on strike"
        with FakeArm():
            result = self.retrieve()
        self.assertFalse(result.success)
        self.assertIn("on strike", result.message)


if __name__ == "__main__":
    rostest.rosrun("smore", "retrieval_node_test", RetrievalNode)
