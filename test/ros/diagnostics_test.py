#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each node tells on /diagnostics how it fares, with the reason where something is wrong."""

import threading
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from octomap_msgs.msg import Octomap
from std_srvs.srv import Trigger

from node_testing import PERIOD, Recorder, Warnings, WristSource, pose, start_node, stamped, wait_until
from smore.srv import PlanPath

STATUSES = [
    "force_torque: wrench",
    "force_torque: sensor",
    "mapping: maps",
    "planner: plans",
    "guard: motion",
]


def values(status):
    return {pair.key: pair.value for pair in status.values}


class LiveSensor:
    """Wrenches at 500 Hz of the clock on the wall, while the block lasts: what is due is sent, however late."""

    def __init__(self, source, **sample):
        self._source = source
        self._sample = sample
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._run)

    def _run(self):
        stamp = rospy.Time.now()
        while not self._end.wait(PERIOD):
            while stamp <= rospy.Time.now():
                self._source.send(stamp=stamp, **self._sample)
                stamp += rospy.Duration.from_sec(PERIOD)

    def __enter__(self):
        self._thread.start()

    def __exit__(self, *_):
        self._end.set()
        self._thread.join()


class Diagnostics(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("diagnostics_test")
        cls.diagnostics = Recorder("/diagnostics", DiagnosticArray)
        cls.warnings = Warnings(rospy.resolve_name("force_torque"))
        cls.source = WristSource()
        assert cls.source.wait_for_listener()
        for name in STATUSES:
            assert cls.wait_for(name, lambda _: True), name
        cls.first = cls.wait_for("force_torque: wrench", lambda _: True)

    @classmethod
    def wait_for(cls, name, condition):
        """The first status of this name, since the last call of `clear`, for which the condition holds."""
        found = []

        def holds(array):
            found[:] = [s for s in array.status if s.name == name and s.values and condition(s)]
            return bool(found)

        return found[0] if cls.diagnostics.wait_for(holds) else None

    def setUp(self):
        self.diagnostics.clear()

    def expect(self, name, level, words):
        status = self.wait_for(name, lambda s: s.level == level and words in s.message)
        self.assertIsNotNone(status, f"{name} does not become {level}: {words}")
        return status

    def test_without_a_sensor_listener_and_maps_are_stale(self):
        self.assertEqual(self.first.level, DiagnosticStatus.STALE)
        self.expect("force_torque: wrench", DiagnosticStatus.STALE, "no wrench")
        self.expect("mapping: maps", DiagnosticStatus.STALE, "")

    def test_a_sensor_that_works_is_told_with_its_rate_and_bias_and_the_maps_with_their_sizes(self):
        maps = Recorder("world/octomap_full", Octomap)
        self.addCleanup(maps.close)
        with LiveSensor(self.source, force=(1.0, 0.0, 0.0)):
            wrench = self.expect("force_torque: wrench", DiagnosticStatus.OK, "wrenches come")
            rated = self.wait_for("force_torque: wrench", lambda s: "rate [Hz]" in values(s))
            sensor = self.expect("force_torque: sensor", DiagnosticStatus.OK, "tared")
            told = self.expect("mapping: maps", DiagnosticStatus.OK, "maps of")
            sized = self.wait_for(
                "mapping: maps", lambda s: values(s)["voxels of the world map"].isdigit()
            )
        self.assertLess(float(values(wrench)["age [s]"]), 2.0)
        self.assertIsNotNone(rated)
        self.assertIn("jitter [s]", values(rated))
        self.assertEqual(values(sensor)["bias of the force [N]"].split()[0], "1")
        self.assertEqual(values(sensor)["contact force [N]"], "5")
        self.assertGreater(float(values(told)["memory [MiB]"]), 1.0)
        self.assertIsNotNone(sized)

    def test_contacts_that_give_no_line_are_told(self):
        stamp = rospy.Time.now()
        for force in 150 * [1.0] + 12 * [9.0] + 60 * [1.0]:  # a contact of 24 ms, and long enough without
            stamp += rospy.Duration.from_sec(PERIOD)
            self.source.send(stamp=stamp, force=(force, 0.0, 0.0))
        told = self.expect("force_torque: sensor", DiagnosticStatus.WARN, "without a line")
        self.assertEqual(values(told)["contacts without a line"], "1")
        self.assertIsNotNone(self.warnings.wait_for("raise contact_force"))
        self.assertTrue(wait_until(lambda: rospy.Time.now() > stamp), "nothing comes before its time")

    def test_dropped_wrenches_and_saturated_ones_are_told(self):
        with LiveSensor(self.source, frame=""):
            dropped = self.expect("force_torque: wrench", DiagnosticStatus.ERROR, "all are dropped")
        self.assertGreater(int(values(dropped)["dropped for their frame_id"]), 0)
        with LiveSensor(self.source, force=(0.0, 0.0, -50.0)):
            self.expect("force_torque: sensor", DiagnosticStatus.ERROR, "end of the sensor's range")

    def test_a_plan_is_told_with_its_time_and_a_refusal_with_its_reason(self):
        plan = rospy.ServiceProxy("plan_path", PlanPath)
        plan.wait_for_service(30.0)
        answer = plan(start=stamped(pose()), goal=stamped(pose(-0.1)))
        self.assertTrue(answer.success, answer.message)
        found = self.expect("planner: plans", DiagnosticStatus.OK, "the last plan took")
        self.assertGreater(float(values(found)["time of the last plan [s]"]), 0.0)
        self.assertAlmostEqual(float(values(found)["length of the last plan [m]"]), 0.1, 2)
        self.assertFalse(plan(start=stamped(pose(), "base"), goal=stamped(pose(-0.1))).success)
        self.expect("planner: plans", DiagnosticStatus.WARN, "'base'")

    def test_the_guards_fault_is_an_error_until_it_is_cleared(self):
        stop = rospy.ServiceProxy("guard/stop", Trigger)
        stop.wait_for_service(30.0)
        self.assertTrue(stop().success)
        self.expect("guard: motion", DiagnosticStatus.ERROR, "stopped by the user")
        self.assertTrue(rospy.ServiceProxy("guard/clear", Trigger)().success)
        self.expect("guard: motion", DiagnosticStatus.OK, "may move")


if __name__ == "__main__":
    rostest.rosrun("smore", "diagnostics_test", Diagnostics)
