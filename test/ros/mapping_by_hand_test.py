#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""mapping.launch on somebody else's sensor and tf: a hand leads the tip of a tool against the sides of a post."""

import random
import struct
import unittest

import numpy as np
import rospy
import rostest
from geometry_msgs.msg import WrenchStamped
from octomap_msgs.msg import Octomap
from sensor_msgs.msg import PointCloud2
from tf2_msgs.msg import TFMessage

from node_testing import PERIOD, Recorder, pose, start_node, transform, wait_until
from smore.msg import ContactObservation

TIP = np.array([0.0, 0.0, 0.15])  # in the tool frame [m]
POST = np.array([0.5, 0.0, 0.3])  # its middle, in the base frame [m]
RADIUS = 0.06  # of the post [m]
AWAY = 0.2  # of the tip from the middle of the post, between two touches [m]
VOXEL = 0.04  # of config/tasks/by_hand.yaml [m]
FORCE = 20.0  # of a touch [N]
NOISE = np.array([1.75] * 3 + [0.1] * 3)  # standard deviations, as by_hand.yaml has them [N], [N m]
BIAS = np.array([3.0, -2.0, 5.0, 0.2, -0.1, 0.1])  # of the sensor [N], [N m]
JITTER = 5e-5  # standard deviation of the stamps [s]
SHIFT = 0.0007  # from a transform to the next wrench [s]
DIRECTIONS = [np.array([np.cos(a), np.sin(a), 0.0]) for a in np.arange(8) * np.pi / 4]


class HandGuidedArm:
    """A driver's topics: wrenches and transforms of 500 Hz, each with stamps of its own that jitter."""

    def __init__(self):
        self.time = 1000.0
        self.tip = POST + AWAY * DIRECTIONS[0]
        self.contact = Recorder("contact", ContactObservation)
        self._random = random.Random(1)
        self._wrench = rospy.Publisher("/ft_sensor/wrench", WrenchStamped, queue_size=10000)
        self._tf = rospy.Publisher("/tf", TFMessage, queue_size=10000)

    def wait_for_listener(self):
        return self.contact.wait_for_publisher() and wait_until(
            lambda: min(p.get_num_connections() for p in (self._wrench, self._tf)) > 0
        )

    def lead(self, target, duration):
        """Moves the tip to `target` with nothing touching, and waits for the listener."""
        begin = self.tip
        count = int(round(duration / PERIOD))
        for i in range(1, count + 1):
            self.tip = begin + (target - begin) * i / count
            stamp = self._sample(np.zeros(3))
        self._wait_for_answer(stamp)

    def press(self, force, duration):
        """Stands while the post presses on the tip with `force` [N], and waits for the listener."""
        for _ in range(int(round(duration / PERIOD))):
            stamp = self._sample(force)
        self._wait_for_answer(stamp)

    def _wait_for_answer(self, stamp):
        # A wrench waits for the transform after it: the last ones have none yet.
        answer = self.contact.wait_for(lambda m: (stamp - m.header.stamp).to_sec() < 0.01)
        assert answer, "the listener does not answer"

    def _stamp(self, time):
        return rospy.Time.from_sec(time + self._random.gauss(0.0, JITTER))

    def _sample(self, force):
        self.time += PERIOD
        at = pose(*(self.tip - TIP)[:2])
        at.position.z = (self.tip - TIP)[2]
        stamp = self._stamp(self.time)
        self._tf.publish(TFMessage([transform("base", "tool0_controller", at, stamp)]))
        noise = [self._random.gauss(0.0, deviation) for deviation in NOISE]
        values = np.concatenate([force, np.cross(TIP, force)]) + BIAS + noise
        message = WrenchStamped()
        message.header.stamp = self._stamp(self.time + SHIFT)
        message.header.frame_id = "tool0_controller"
        for vector, part in ((message.wrench.force, values[:3]), (message.wrench.torque, values[3:])):
            vector.x, vector.y, vector.z = part
        self._wrench.publish(message)
        return stamp


def distance_to_line(point, line):
    direction = np.array([line.direction.x, line.direction.y, line.direction.z])
    offset = point - np.array([line.point.x, line.point.y, line.point.z])
    return np.linalg.norm(np.cross(offset, direction)) / np.linalg.norm(direction)


def points_of(cloud):
    count = cloud.width * cloud.height
    rows = [struct.unpack_from("<fff", cloud.data, i * cloud.point_step) for i in range(count)]
    return np.array(rows).reshape(-1, 3)


class MappingByHand(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("mapping_by_hand_test")
        cls.arm = HandGuidedArm()
        assert cls.arm.wait_for_listener()
        for _ in range(4):
            cls.arm.lead(cls.arm.tip, 0.5)
        messages = cls.arm.contact.messages()
        assert messages[-1].state == ContactObservation.FREE, "not tared"
        for direction in DIRECTIONS:
            cls.arm.lead(POST + AWAY * direction, 0.5)
            cls.arm.lead(POST + RADIUS * direction, 0.5)
            cls.arm.press(FORCE * direction, 0.5)
            cls.arm.lead(POST + AWAY * direction, 0.5)
        cls.observations = cls.arm.contact.messages()

    def test_each_touch_is_one_contact_whose_line_passes_the_tip(self):
        self.assertEqual(self.observations[-1].contact_id, len(DIRECTIONS))
        lines = [m.line for m in self.observations if m.has_line]
        self.assertEqual(len(lines), len(DIRECTIONS))
        for line in lines:
            self.assertLess(distance_to_line(TIP, line), 0.03)

    def test_both_maps_come_in_the_users_frames(self):
        for space, frame in (("world", "base"), ("object", "tool0_controller")):
            octomap = Recorder(space + "/octomap_full", Octomap)
            message = octomap.wait_for(lambda map_: len(map_.data) > 0)
            self.assertIsNotNone(message, space)
            self.assertEqual(message.header.frame_id, frame)

    def nearest(self, space, place):
        """Whether an occupied voxel comes within two voxels of `place` [m]."""
        cloud = Recorder(space + "/octomap_point_cloud_centers", PointCloud2)
        self.addCleanup(cloud.close)

        def is_near(message):
            points = points_of(message)
            return len(points) and np.linalg.norm(points - place, axis=1).min() < 2.0 * VOXEL

        return cloud.wait_for(is_near)

    def test_the_object_is_occupied_at_its_tip_and_the_world_where_it_was_touched(self):
        self.assertIsNotNone(self.nearest("object", TIP))
        for direction in DIRECTIONS:
            self.assertIsNotNone(self.nearest("world", POST + RADIUS * direction), direction)


if __name__ == "__main__":
    rostest.rosrun("smore", "mapping_by_hand_test", MappingByHand)
