#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The retrieval zeroes the sensor before it starts; the test plays driver and listener."""

import threading
import unittest

import actionlib
import rospy
import rostest
from geometry_msgs.msg import WrenchStamped
from std_msgs.msg import String
from std_srvs.srv import Trigger, TriggerResponse

from action_clients import has_ended
from node_testing import start_node, wait_until
from observations import ObservationSource
from smore.msg import ContactObservation, RetrieveAction, RetrieveGoal

DEADLINE = rospy.Duration(30.0)
OFFSET = 12.0  # of the sensor that has not been zeroed [N]
LATENCY = 200  # samples from the driver's answer to the zeroing


class Driver:
    """A sensor whose zero service answers long before the zeroing, and a listener that only tares.

    Observations say CONTACT throughout, so that no retrieval gets beyond its preparations.
    """

    def __init__(self):
        self.zeroes = True
        self.swings = False
        self.refuses = False
        self.x = 0.0
        self.force = OFFSET
        self.asked = 0
        self.one_in = 1  # of the wrenches: 20 makes 50 Hz of them
        self.presses = False  # in the eyes of the listener
        self.suspended_at = []  # the raw force at each suspension [N]
        self.tared_at = []  # the raw force at each tare [N]
        self._zero_in = None
        self._stop = threading.Event()
        self._wrench = rospy.Publisher("wrench", WrenchStamped, queue_size=100)
        self._observations = ObservationSource()
        self.offer_zero()
        self._suspend_service = rospy.Service("force_torque/suspend", Trigger, self._suspend)
        self._tare_service = rospy.Service("force_torque/tare", Trigger, self._tare)
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def offer_zero(self):
        self.zero_service = rospy.Service("driver/zero", Trigger, self._zero)

    def _zero(self, _):
        self.asked += 1
        if self.refuses:
            return TriggerResponse(False, "the robot is off")
        if self.zeroes:
            self._zero_in = LATENCY
        return TriggerResponse(True, "")

    def _suspend(self, _):
        self.suspended_at.append(self.force)
        return TriggerResponse(not self.presses, "something presses" if self.presses else "")

    def _tare(self, _):
        self.tared_at.append(self.force)
        return TriggerResponse(True, "tared")

    def _run(self):
        count = 0
        while not self._stop.wait(0.001):
            count += 1
            if self._zero_in is not None:
                self._zero_in -= 1
                if self._zero_in == 0:
                    self.force = OFFSET / 4.0 if self.swings else 0.0
                    self.swings = False
                    self._zero_in = None
            if self.one_in and count % self.one_in == 0:
                message = WrenchStamped()
                message.header.stamp = rospy.Time.now()
                message.wrench.force.z = self.force
                self._wrench.publish(message)
            observation = self._observations.next(ContactObservation.CONTACT, self.x)
            self._observations.publish(observation)

    def stand_until_heard(self):
        """Waits until what was said of the pose has had time to arrive."""
        begin = self._observations.time
        wait_until(lambda: self._observations.time > begin + 1.0)

    def close(self):
        self._stop.set()
        self._thread.join()


class SensorZero(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("sensor_zero_test")
        cls.driver = Driver()
        cls.guard = rospy.Publisher("guard/fault", String, queue_size=1, latch=True)
        cls.client = actionlib.SimpleActionClient("retrieve", RetrieveAction)
        assert cls.client.wait_for_server(DEADLINE)
        assert wait_until(lambda: cls.guard.get_num_connections() > 0)

    @classmethod
    def tearDownClass(cls):
        cls.driver.close()

    def setUp(self):
        self.driver.zeroes = True
        self.driver.refuses = False
        self.driver.force = OFFSET
        self.driver.presses = False
        self.driver.one_in = 1
        self.driver.asked = 0
        self.driver.suspended_at.clear()
        self.driver.tared_at.clear()

    def retrieve(self):
        self.client.send_goal(RetrieveGoal())
        self.assertTrue(has_ended(self.client))
        return self.client.get_result()

    def test_the_listener_knows_before_and_the_tare_waits_until_the_zeroing_has_happened(self):
        self.retrieve()
        self.assertEqual(self.driver.suspended_at, [OFFSET])
        self.assertEqual(self.driver.tared_at, [0.0])

    def test_nothing_is_zeroed_under_what_presses(self):
        self.driver.presses = True
        result = self.retrieve()
        self.assertFalse(result.success)
        self.assertIn("/force_torque/suspend' failed: something presses", result.message)
        self.assertEqual(self.driver.asked, 0)

    def test_a_zeroing_while_the_object_swung_is_repeated(self):
        self.driver.swings = True
        self.retrieve()
        self.assertGreater(self.driver.asked, 1)
        self.assertEqual(self.driver.tared_at, [0.0])

    def test_a_sensor_that_is_near_zero_already_is_tared_at_once(self):
        self.driver.zeroes = False
        self.driver.force = 0.3
        self.retrieve()
        self.assertEqual(self.driver.tared_at, [0.3])

    def test_a_sensor_of_50_hz_is_zeroed_once(self):
        self.driver.one_in = 20
        self.retrieve()
        self.assertEqual(self.driver.tared_at, [0.0])
        self.assertEqual(self.driver.asked, 1)

    def test_a_zeroing_of_a_sensor_that_says_nothing_is_told_as_that(self):
        self.driver.one_in = 0
        result = self.retrieve()
        self.assertFalse(result.success)
        self.assertIn("wrenches came in 1.5 s on '/wrench'", result.message)

    def test_a_zeroing_that_never_happens_is_told_with_the_force(self):
        self.driver.zeroes = False
        result = self.retrieve()
        self.assertFalse(result.success)
        self.assertIn("the raw force is 12 N", result.message)
        self.assertEqual(self.driver.tared_at, [])

    def test_a_service_that_is_missing_is_named(self):
        self.driver.zero_service.shutdown()
        self.addCleanup(self.driver.offer_zero)
        result = self.retrieve()
        self.assertFalse(result.success)
        self.assertIn("the service '/driver/zero' does not appear", result.message)

    def test_a_service_that_fails_is_named_with_its_reason(self):
        self.driver.refuses = True
        result = self.retrieve()
        self.assertFalse(result.success)
        self.assertIn("the service '/driver/zero' failed: the robot is off", result.message)

    def test_nothing_is_zeroed_where_a_fault_stopped_the_robot(self):
        self.guard.publish("the force is 45 N")
        self.driver.stand_until_heard()
        self.guard.publish("")
        self.driver.stand_until_heard()
        self.retrieve()
        self.assertEqual(self.driver.asked, 0)
        self.driver.x -= 0.02
        self.driver.stand_until_heard()
        self.retrieve()
        self.assertGreater(self.driver.asked, 0)


if __name__ == "__main__":
    rostest.rosrun("smore", "sensor_zero_test", SensorZero)
