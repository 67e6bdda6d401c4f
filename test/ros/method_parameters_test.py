#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A file of parameters that a launch file is given reaches mapping and planner."""

import unittest

import rospy
import rostest

from node_testing import DEADLINE, pose, stamped, start_node, wait_until
from observations import ObservationSource
from smore.srv import CheckPose, TwinMaps, TwinMapsRequest

LOOPS = ("plain", "changed")


class MethodParameters(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("method_parameters_test")
        cls.maps = [cls.service(f"{loop}/twin_maps", TwinMaps) for loop in LOOPS]
        cls.checks = [cls.service(f"{loop}/check_pose", CheckPose) for loop in LOOPS]
        source = ObservationSource()
        # Two mappings and two retrievals.
        assert wait_until(lambda: source.publisher.get_num_connections() == 4)
        source.stay(0.1, x=-0.2)
        cls.stamp = source.touch(x=-0.1)

    @staticmethod
    def service(name, kind):
        rospy.wait_for_service(name, DEADLINE)
        return rospy.ServiceProxy(name, kind)

    def test_the_mapping_knows_another_map(self):
        request = TwinMapsRequest(not_before=self.stamp, timeout=rospy.Duration(DEADLINE))
        request.with_octrees = True
        plain, changed = [maps(request) for maps in self.maps]
        self.assertTrue(plain.success and changed.success)
        self.assertGreater(len(plain.world.data), 0)
        self.assertNotEqual(plain.world.data, changed.world.data)

    def test_the_planner_sees_other_risks(self):
        answers = [check(stamped(pose(-0.05))) for check in self.checks]
        for answer in answers:
            self.assertTrue(answer.success, answer.message)
        self.assertGreater(answers[0].risk, 0.0)
        self.assertNotEqual(answers[0].risk, answers[1].risk)


if __name__ == "__main__":
    rostest.rosrun("smore", "method_parameters_test", MethodParameters)
