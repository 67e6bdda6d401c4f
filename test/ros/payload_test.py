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

GRAVITY = 9.80665  # [m/s^2]
MASS = 1.4  # [kg]
OTHER_MASS = 3.0  # of another object [kg]: as it is gripped, it feels like a contact
CENTER = (0.02, -0.01, 0.15)  # of mass, in the object frame [m]
BIAS = (3.0, -5.0, 8.0)  # [N]
STAND = 0.8  # [s] at each pose
TILT = 0.4  # [rad]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def tilted(axis, angle, mass=MASS):
    """Pose and raw wrench of the object turned about its x axis (0) or y axis (1)."""
    weight = mass * GRAVITY
    half = [0.0, 0.0]
    half[axis] = math.sin(angle / 2.0)
    at = pose()
    at.orientation = Quaternion(half[0], half[1], 0.0, math.cos(angle / 2.0))
    level = -weight * math.cos(angle)
    aside = weight * math.sin(angle)
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

    def stand(self, axis, angle, mass=MASS):
        """Stands at a tilt until the listener has taken it all; what it says at last."""
        stamp = self.source.send_for(STAND, **tilted(axis, angle, mass))
        answer = self.contact.wait_for(lambda message: message.header.stamp == stamp)
        self.assertIsNotNone(answer)
        return answer.state

    def call(self, name, axis, angle, mass=MASS, press=(0.0, 0.0, 0.0)):
        """The service's reply while the robot stands at a tilt, and something presses [N]."""
        sample = tilted(axis, angle, mass)
        sample["force"] = tuple(f + p for f, p in zip(sample["force"], press))
        self.source.send_for(0.1, **sample)
        replies = []
        service = rospy.ServiceProxy("force_torque/" + name, Trigger)
        caller = threading.Thread(target=lambda: replies.append(service()))
        caller.start()
        while caller.is_alive():
            self.source.send(**sample)
            caller.join(0.001)
        return replies[0]

    def tilt(self, mass=MASS):
        """What the listener says at four tilts."""
        tilts = ((0, TILT), (0, -TILT), (1, TILT), (1, -TILT))
        return [self.stand(axis, angle, mass) for axis, angle in tilts]

    def test_weight_is_felt_until_the_payload_is_known(self):
        free = ContactObservation.FREE
        self.assertEqual(self.stand(0, 0.0), free)
        refused = self.call("identify_payload", 0, 0.0)
        self.assertFalse(refused.success)
        self.assertIn("poses", refused.message)
        self.assertNotIn(free, self.tilt())

        pressed = self.call("identify_payload", 1, -TILT, press=(0.0, 0.0, 20.0))
        self.assertFalse(pressed.success)
        self.assertIn("presses with", pressed.message)
        reply = self.call("identify_payload", 1, -TILT)
        self.assertTrue(reply.success, reply.message)
        self.assertIn("1.4 kg at (", reply.message)
        self.assertEqual(self.stand(0, 0.3), free)
        self.compensated.clear()
        stamp = self.source.send_for(0.1, **tilted(1, 0.7))
        felt = self.compensated.wait_for(lambda message: message.header.stamp == stamp).wrench
        for component in (felt.force.x, felt.force.y, felt.force.z, felt.torque.x, felt.torque.y):
            self.assertAlmostEqual(component, 0.0, 4)
        self.another_object_is_gripped()

    def another_object_is_gripped(self):
        self.assertEqual(self.stand(0, 0.0, OTHER_MASS), ContactObservation.CONTACT)
        self.assertFalse(self.call("tare", 0, 0.0, OTHER_MASS).success, "it might be a touch")
        jammed = self.call("forget_payload", 0, 0.0, OTHER_MASS, press=(20.0, 0.0, 0.0))
        self.assertFalse(jammed.success)
        self.assertIn("across gravity", jammed.message)
        self.assertEqual(self.stand(0, 0.0, OTHER_MASS), ContactObservation.CONTACT)
        forgotten = self.call("forget_payload", 0, 0.0, OTHER_MASS)
        self.assertTrue(forgotten.success, forgotten.message)
        self.assertEqual(self.stand(0, 0.0, OTHER_MASS), ContactObservation.FREE)
        self.assertNotIn(ContactObservation.FREE, self.tilt(OTHER_MASS))
        reply = self.call("identify_payload", 1, -TILT, OTHER_MASS)
        self.assertTrue(reply.success, reply.message)
        self.assertIn("3 kg at (", reply.message)
        self.assertEqual(self.stand(0, 0.3, OTHER_MASS), ContactObservation.FREE)


if __name__ == "__main__":
    rostest.rosrun("smore", "payload_test", Payload)
