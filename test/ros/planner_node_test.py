#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The planner beside a mapping that is fed with generated observations."""

import math
import unittest

import rospy
import rostest
from nav_msgs.msg import Path
from std_srvs.srv import Trigger
from visualization_msgs.msg import MarkerArray

from node_testing import Recorder, pose, stamped, start_node
from observations import ObservationSource
from smore.srv import CheckPose, PlanPath, PlanPathRequest, PlanTouch


class PlannerNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("planner_node_test")
        for service in ("plan_path", "plan_touch", "check_pose", "reset"):
            rospy.wait_for_service(service, 30.0)
        cls.source = ObservationSource()
        assert cls.source.wait_for_listener()
        cls.plan_path = rospy.ServiceProxy("plan_path", PlanPath)
        cls.plan_touch = rospy.ServiceProxy("plan_touch", PlanTouch)
        cls.check_pose = rospy.ServiceProxy("check_pose", CheckPose)

    def plan(self, start=None, goal=None, not_before=rospy.Time()):
        return self.plan_path(
            PlanPathRequest(
                start=start or stamped(pose()), goal=goal or stamped(pose(-0.3)), not_before=not_before
            )
        )

    def test_a_path_leads_from_start_to_goal_and_is_shown(self):
        paths = Recorder("path", Path)
        markers = Recorder("path_risk", MarkerArray)
        tree = Recorder("plan_tree", MarkerArray)
        self.assertTrue(tree.wait_for_publisher())
        answer = self.plan()
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.path.header.frame_id, "world")
        self.assertAlmostEqual(answer.path.poses[0].pose.position.x, 0.0)
        self.assertAlmostEqual(answer.path.poses[-1].pose.position.x, -0.3)
        self.assertGreaterEqual(answer.risk, 0.0)
        self.assertLessEqual(answer.risk, 1.0)
        self.assertIsNotNone(paths.wait_for(lambda path: path.poses == answer.path.poses))
        self.assertIsNotNone(markers.wait_for(lambda array: array.markers[0].points))
        self.assertIsNotNone(tree.wait_for(lambda array: array.markers[0].points))

    def test_it_plans_on_maps_that_hold_the_newest_contact(self):
        before = self.plan().revision
        stamp = self.source.touch()
        answer = self.plan(not_before=stamp)
        self.assertTrue(answer.success, answer.message)
        self.assertGreater(answer.revision, before)

    def test_touches_begin_where_the_object_is_and_know_the_newest_contact(self):
        stamp = self.source.touch()
        answer = self.plan_touch(start=stamped(pose()), not_before=stamp)
        self.assertTrue(answer.success, answer.message)
        self.assertAlmostEqual(answer.path.poses[0].pose.position.x, 0.0)
        self.assertGreaterEqual(len(answer.path.poses), 2)
        answer = self.plan_touch(start=stamped(pose(), "base"), not_before=stamp)
        self.assertFalse(answer.success)
        self.assertIn("'base'", answer.message)

    def test_it_never_plans_on_stale_maps(self):
        later = rospy.Time.from_sec(self.source.time + 50.0)
        answer = self.plan(not_before=later)
        self.assertFalse(answer.success)
        self.assertIn("up to the time", answer.message)

    def test_it_follows_a_reset_of_the_maps(self):
        self.assertTrue(self.plan(not_before=self.source.touch()).success)
        self.assertTrue(rospy.ServiceProxy("reset", Trigger)().success)
        self.assertTrue(self.plan(not_before=self.source.touch()).success)

    def test_bad_requests_are_answered_with_the_reason(self):
        for arguments, reason in (
            ({"start": stamped(pose(), "base")}, "'base'"),
            ({"goal": stamped(pose(math.nan))}, "not finite"),
            ({"goal": stamped(pose(5.0))}, "goal"),
        ):
            answer = self.plan(**arguments)
            self.assertFalse(answer.success)
            self.assertIn(reason, answer.message)

    def test_poses_are_checked(self):
        answer = self.check_pose(stamped(pose()))
        self.assertTrue(answer.success and answer.valid)
        answer = self.check_pose(stamped(pose(5.0)))
        self.assertTrue(answer.success)
        self.assertFalse(answer.valid)
        self.assertIn("outside of the workspace", answer.message)
        answer = self.check_pose(stamped(pose(), "elsewhere"))
        self.assertFalse(answer.success)
        self.assertIn("'elsewhere'", answer.message)


if __name__ == "__main__":
    rostest.rosrun("smore", "planner_node_test", PlannerNode)
