#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The guard's limits are lowered while it runs, and never above what was configured."""

import unittest

import rospy
import rostest
from dynamic_reconfigure.client import Client
from std_msgs.msg import String
from std_srvs.srv import Trigger

from guarded_driver import Driver
from node_testing import DEADLINE, Recorder, Warnings, start_node, wait_until

CONFIGURED = {"max_force": 40.0, "max_torque": 8.0, "max_joint_speed": 2.0}


class GuardLimits(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("guard_limits_test")
        cls.limits = Client("guard", timeout=DEADLINE)
        cls.clear = rospy.ServiceProxy("guard/clear", Trigger)
        cls.faults = Recorder("guard/fault", String)
        cls.warnings = Warnings(rospy.resolve_name("guard"))
        assert cls.faults.wait_for_publisher() and cls.warnings.wait_for_publisher()

    def setUp(self):
        self.driver = Driver()
        self.addCleanup(self.driver.close)
        self.change(**CONFIGURED)
        self.assertTrue(wait_until(lambda: self.driver.felt > 20))
        self.assertTrue(wait_until(lambda: self.clear().success))
        self.faults.clear()

    def change(self, **wished):
        """What is in force then."""
        answer = self.limits.update_configuration(wished)
        return {name: answer[name] for name in CONFIGURED}

    def trips(self, force, words):
        self.driver.force = force
        said = self.faults.wait_for(lambda message: message.data)
        self.assertIn(words, said.data)

    def test_it_trips_at_a_ceiling_that_was_lowered(self):
        self.assertEqual(self.change(max_force=20.0), {**CONFIGURED, "max_force": 20.0})
        self.trips(25.0, "the force is 25 N, above the limit of 20 N")

    def test_it_trips_where_the_force_is_above_a_ceiling_as_it_is_lowered(self):
        self.driver.force = 25.0
        felt = self.driver.felt
        self.assertTrue(wait_until(lambda: self.driver.felt > felt + 20))
        self.assertFalse([message for message in self.faults.messages() if message.data])
        self.change(max_force=20.0)
        self.trips(25.0, "the force is 25 N, above the limit of 20 N")

    def test_no_limit_rises_above_what_was_configured(self):
        in_force = self.change(max_force=41.0, max_torque=3.0, max_joint_speed=2.5)
        self.assertEqual(in_force, {**CONFIGURED, "max_torque": 3.0})
        for words in ("max_force' stays 40: 41 is not within 1 to 40", "max_joint_speed' stays 2: 2.5"):
            self.assertTrue(self.warnings.wait_for(words), words)
        self.trips(40.5, "above the limit of 40 N")

    def test_what_is_no_limit_is_refused(self):
        self.assertEqual(self.change(max_force=float("nan")), CONFIGURED)
        self.assertEqual(self.change(max_force=-1.0, max_torque=0.0), CONFIGURED)

    def test_a_lowered_limit_may_be_what_was_configured_again(self):
        self.change(max_force=20.0)
        self.assertEqual(self.change(max_force=40.0), CONFIGURED)
        self.trips(45.0, "above the limit of 40 N")

    def test_others_are_told_what_may_be_chosen(self):
        force = next(p for p in self.limits.get_parameter_descriptions(DEADLINE) if p["name"] == "max_force")
        self.assertEqual((force["min"], force["max"], force["default"]), (1.0, 40.0, 40.0))


if __name__ == "__main__":
    rostest.rosrun("smore", "guard_limits_test", GuardLimits)
