#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The listener identifies what the wrist carries when asked."""

import math
import threading
import unittest

import rospy
import rostest
from geometry_msgs.msg import Quaternion, WrenchStamped
from std_srvs.srv import Trigger

from node_testing import Recorder, WristSource, pose, start_node
from smore.msg import ContactObservation

WEIGHT = 1.4 * 9.80665  # [N]
CENTER = (0.02, -0.01, 0.15)  # of mass, in the object frame [m]
BIAS = (3.0, -5.0, 8.0)  # [N]
STAND = 0.8  # [s] at each pose
TILT = 0.4  # [rad]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def tilted(axis, angle):
    """Pose and raw wrench of the object turned about its x axis (0) or y axis (1)."""
    half = [0.0, 0.0]
    half[axis] = math.sin(angle / 2.0)
    at = pose()
    at.orientation = Quaternion(half[0], half[1], 0.0, math.cos(angle / 2.0))
    level = -WEIGHT * math.cos(angle)
    aside = WEIGHT * math.sin(angle)
    weight = (0.0, -aside, level) if axis == 0 else (aside, 0.0, level)
    force = tuple(b + w for b, w in zip(BIAS, weight))
    return {"at": at, "force": force, "torque": cross(CENTER, weight)}


class Payload(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("payload_test")
        cls.contact = Recorder("contact", ContactObservation)
        cls.compensated = Recorder("wrench_compensated", WrenchStamped)
        cls.source = WristSource()
        for recorder in (cls.contact, cls.compensated):
            assert recorder.wait_for_publisher()
        assert cls.source.wait_for_listener()

    def stand(self, axis, angle):
        """Stands at a tilt until the listener has taken it all; what it says at last."""
        stamp = self.source.send_for(STAND, **tilted(axis, angle))
        answer = self.contact.wait_for(lambda message: message.header.stamp == stamp)
        self.assertIsNotNone(answer)
        return answer.state

    def identify(self, axis, angle, press=0.0):
        """The service's reply while the robot stands at a tilt, and something presses from below [N]."""
        sample = tilted(axis, angle)
        sample["force"] = (*sample["force"][:2], sample["force"][2] + press)
        self.source.send_for(0.1, **sample)
        replies = []
        service = rospy.ServiceProxy("force_torque/identify_payload", Trigger)
        caller = threading.Thread(target=lambda: replies.append(service()))
        caller.start()
        while caller.is_alive():
            self.source.send(**sample)
            caller.join(0.001)
        return replies[0]

    def test_weight_is_felt_until_the_payload_is_known(self):
        free = ContactObservation.FREE
        self.assertEqual(self.stand(0, 0.0), free)
        refused = self.identify(0, 0.0)
        self.assertFalse(refused.success)
        self.assertIn("poses", refused.message)

        for axis, angle in ((0, TILT), (0, -TILT), (1, TILT), (1, -TILT)):
            self.assertNotEqual(self.stand(axis, angle), free)

        pressed = self.identify(1, -TILT, press=20.0)
        self.assertFalse(pressed.success)
        self.assertIn("presses with", pressed.message)
        reply = self.identify(1, -TILT)
        self.assertTrue(reply.success, reply.message)
        self.assertIn("1.4 kg at (", reply.message)
        self.assertEqual(self.stand(0, 0.3), free)
        self.compensated.clear()
        stamp = self.source.send_for(0.1, **tilted(1, 0.7))
        felt = self.compensated.wait_for(lambda message: message.header.stamp == stamp).wrench
        for component in (felt.force.x, felt.force.y, felt.force.z, felt.torque.x, felt.torque.y):
            self.assertAlmostEqual(component, 0.0, 4)


if __name__ == "__main__":
    rostest.rosrun("smore", "payload_test", Payload)
