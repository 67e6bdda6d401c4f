#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is told to the running mapping node counts for its maps, for the planner, and in what is saved."""

import os
import shutil
import struct
import tempfile
import unittest

import rospy
import rostest
from geometry_msgs.msg import Point, Pose, Quaternion
from octomap_msgs.srv import GetOctomap
from sensor_msgs.msg import PointCloud2, PointField
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

from node_testing import pose, stamped, start_node, transform
from smore.srv import CheckPose, InsertPrior, InsertPriorRequest, LoadBelief, SaveBelief

STEP = 0.005  # between points [m]
SQUARE = [(STEP * i, STEP * j, 0.0) for i in range(-5, 6) for j in range(-5, 6)]
BAR = [(x, 3.0 * y, 0.0) for x, y, _ in SQUARE]  # the object
PEG = [(x - 0.15, y + 0.05, 0.0) for x, y, _ in SQUARE]  # in the world, on the way to the goal


def cloud_of(points, frame):
    cloud = PointCloud2(width=len(points), height=1, point_step=12, row_step=12 * len(points))
    cloud.header.frame_id = frame
    cloud.fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate("xyz")]
    cloud.data = b"".join(struct.pack("<3f", *point) for point in points)
    return cloud


class InsertPriorTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("insert_prior_test")
        for service in ("check_pose", "insert_prior", "object/reset"):
            rospy.wait_for_service(service, 30.0)
        cls.folder = tempfile.mkdtemp()

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)
        home = os.environ.get("ROS_HOME", os.path.join(os.path.expanduser("~"), ".ros"))
        shutil.rmtree(os.path.join(home, rospy.get_param("mapping/beliefs")), ignore_errors=True)

    def setUp(self):
        self.call("reset")

    def call(self, service):
        answer = rospy.ServiceProxy(service, Trigger)()
        self.assertTrue(answer.success, answer.message)

    @staticmethod
    def insert(**fields):
        return rospy.ServiceProxy("insert_prior", InsertPrior)(InsertPriorRequest(**fields))

    def told(self, **fields):
        answer = self.insert(**fields)
        self.assertTrue(answer.success, answer.message)
        return answer.message

    def tell_all(self):
        self.told(map="world", cloud=cloud_of(PEG, "world"))
        file = os.path.join(self.folder, "bar.ply")
        with open(file, "w", encoding="ascii") as stream:
            stream.write(
                "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n" % len(BAR)
            )
            stream.writelines("%g %g %g\n" % point for point in BAR)
        self.assertIn("bar.ply", self.told(map="object", file=file, confidence=0.9))

    def risk_at(self, x, y=0.0):
        answer = rospy.ServiceProxy("check_pose", CheckPose)(pose=stamped(pose(x, y)))
        self.assertTrue(answer.success, answer.message)
        return answer.risk

    @staticmethod
    def size_of(space):
        return len(rospy.ServiceProxy(space + "/octomap_full", GetOctomap)().map.data)

    def test_the_planner_knows_it_at_once(self):
        self.assertLess(self.risk_at(-0.15), 0.1)
        self.tell_all()
        self.assertGreater(self.risk_at(-0.15), 0.8)
        self.assertLess(self.risk_at(0.1), 0.1)
        self.assertGreater(min(self.size_of("world"), self.size_of("object")), 0)

    def test_a_cameras_cloud_is_placed_by_tf(self):
        mount = Pose(Point(-0.1, 0.0, 0.5), Quaternion(1.0, 0.0, 0.0, 0.0))  # looks down
        static = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        static.publish(TFMessage([transform("world", "camera", mount, rospy.Time())]))
        seen = cloud_of([(x + 0.1, -y, 0.5 - z) for x, y, z in PEG], "camera")
        seen.header.stamp = rospy.Time(5.0)
        self.told(map="world", cloud=seen)
        self.told(map="object", cloud=cloud_of(BAR, "object"))
        self.assertGreater(self.risk_at(-0.15), 0.8)

    def test_a_reset_forgets_it(self):
        self.tell_all()
        self.call("reset")
        self.assertLess(self.risk_at(-0.15), 0.1)

    def test_it_is_saved_and_loaded(self):
        self.tell_all()
        saved = rospy.ServiceProxy("save_belief", SaveBelief)("told", True)
        self.assertTrue(saved.success, saved.message)
        self.call("reset")
        loaded = rospy.ServiceProxy("load_belief", LoadBelief)("told")
        self.assertTrue(loaded.success, loaded.message)
        self.assertGreater(self.risk_at(-0.15), 0.8)

    def test_a_new_grasp_begins_with_an_empty_object_map(self):
        self.tell_all()
        full = self.size_of("object")
        world = self.size_of("world")
        self.call("object/reset")
        self.assertLess(self.size_of("object"), full)
        self.assertEqual(self.size_of("world"), world)
        self.assertLess(self.risk_at(-0.15), 0.1)

    def test_a_new_place_begins_with_an_empty_world_map(self):
        self.tell_all()
        full = self.size_of("object")
        self.call("world/reset")
        self.assertEqual(self.size_of("object"), full)
        self.assertLess(self.risk_at(-0.15), 0.1)

    def test_what_cannot_be_told_changes_nothing(self):
        self.tell_all()
        world = self.size_of("world")
        for fields, says in (
            ({"map": "moon", "cloud": cloud_of(PEG, "world")}, "moon"),
            ({"map": "object", "cloud": cloud_of(PEG, "world")}, "'world'"),
            ({"map": "world", "file": "/missing.stl"}, "missing.stl"),
            ({"map": "world", "cloud": cloud_of([(0.0, 0.0, 0.5)], "world")}, "the plane"),
        ):
            answer = self.insert(**fields)
            self.assertFalse(answer.success)
            self.assertIn(says, answer.message)
        self.assertEqual(self.size_of("world"), world)


if __name__ == "__main__":
    rostest.rosrun("smore", "insert_prior", InsertPriorTest)
