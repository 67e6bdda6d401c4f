#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Mapping and planner know what the scenario says to be known beforehand, without a single observation."""

import unittest

import rospy
import rostest
from octomap_msgs.msg import Octomap
from std_srvs.srv import Trigger
from visualization_msgs.msg import MarkerArray

from node_testing import Recorder, pose, stamped, start_node
from smore.srv import CheckPose, PlanPath, PlanPathRequest


class KnownScene(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("known_scene_test")
        for service in ("plan_path", "check_pose", "reset"):
            rospy.wait_for_service(service, 30.0)
        cls.check_pose = rospy.ServiceProxy("check_pose", CheckPose)
        cls.plan_path = rospy.ServiceProxy("plan_path", PlanPath)

    def risk_at(self, x, y):
        answer = self.check_pose(pose=stamped(pose(x, y)))
        self.assertTrue(answer.success, answer.message)
        return answer.risk

    def test_1_poses_touch_where_matter_is_known(self):
        self.assertGreater(self.risk_at(-0.15, 0.0), 0.9)
        self.assertLess(self.risk_at(0.1, -0.15), 0.1)

    def test_2_the_maps_show_it(self):
        for name in ("world/octomap_full", "object/octomap_full"):
            self.assertIsNotNone(Recorder(name, Octomap).wait_for(lambda map_: len(map_.data) > 0))

    def plan_to(self, x):
        answer = self.plan_path(PlanPathRequest(start=stamped(pose()), goal=stamped(pose(x))))
        self.assertTrue(answer.success, answer.message)
        return answer

    def test_3_the_way_leads_past_it(self):
        self.assertGreater(len(self.plan_to(-0.3).path.poses), 2, "the straight way is barred")

    def test_4_who_looks_only_now_sees_the_object_on_the_last_way(self):
        for goal in (-0.3, 0.1):  # nobody has looked yet; nobody looks any more
            self.plan_to(goal)
            ghost = Recorder("path_ghost", MarkerArray)
            at_goal = lambda array, x=goal: abs(array.markers[-1].pose.position.x - x) < 0.05
            self.assertIsNotNone(ghost.wait_for(at_goal), goal)
            ghost.close()

    def test_5_a_reset_forgets_what_was_observed_alone(self):
        self.assertTrue(rospy.ServiceProxy("reset", Trigger)().success)
        self.assertGreater(self.risk_at(-0.15, 0.0), 0.9)


if __name__ == "__main__":
    rostest.rosrun("smore", "known_scene_test", KnownScene)
