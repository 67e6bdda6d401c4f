#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the mapping node has learnt: saved and loaded, and the same after the node was killed."""

import os
import shutil
import signal
import unittest

import rosgraph
import rospy
import rostest
from octomap_msgs.srv import GetOctomap
from std_srvs.srv import Trigger

from node_killing import CALLER, api_of
from node_testing import start_node, wait_until
from observations import ObservationSource
from smore.srv import LoadBelief, SaveBelief, TwinMaps, TwinMapsRequest

NODE = "mapping"


def below_ros_home(path):
    home = os.environ.get("ROS_HOME", os.path.join(os.path.expanduser("~"), ".ros"))
    return os.path.join(home, path)


def process_of(node):
    """None while there is none."""
    try:
        return api_of(node).getPid(CALLER)[2]
    except (OSError, rosgraph.MasterError):
        return None


class KeptBelief(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("kept_belief_test")
        for service in ("twin_maps", "reset", "save_belief", "load_belief"):
            rospy.wait_for_service(service, 30.0)
        cls.source = ObservationSource()
        assert cls.source.wait_for_listener()

    @classmethod
    def tearDownClass(cls):
        for name in ("journal", "beliefs"):
            shutil.rmtree(below_ros_home(rospy.get_param(NODE + "/" + name)), ignore_errors=True)

    def setUp(self):
        self.assertTrue(rospy.ServiceProxy("reset", Trigger)().success)

    def learn(self):
        stamp = None
        for x in (0.0, 0.05, -0.04):
            stamp = self.source.touch(x)
        request = TwinMapsRequest(not_before=stamp, timeout=rospy.Duration(20.0))
        self.assertTrue(rospy.ServiceProxy("twin_maps", TwinMaps)(request).success)

    @staticmethod
    def maps():
        return [
            rospy.ServiceProxy(space + "/octomap_full", GetOctomap)().map.data
            for space in ("world", "object")
        ]

    def save(self, name, overwrite=False):
        return rospy.ServiceProxy("save_belief", SaveBelief)(name, overwrite)

    def load(self, name):
        return rospy.ServiceProxy("load_belief", LoadBelief)(name)

    def test_a_saved_belief_is_loaded_to_the_byte(self):
        self.learn()
        learnt = self.maps()
        self.assertTrue(all(learnt))
        saved = self.save("shelf/mug")
        self.assertTrue(saved.success, saved.message)
        self.assertIn("shelf/mug.evidence", saved.message)
        rospy.ServiceProxy("reset", Trigger)()
        self.assertNotEqual(self.maps(), learnt)
        loaded = self.load("shelf/mug")
        self.assertTrue(loaded.success, loaded.message)
        self.assertIn("3 lines", loaded.message)
        self.assertEqual(self.maps(), learnt)

    def test_nothing_is_written_over_without_being_told(self):
        self.learn()
        self.assertTrue(self.save("once").success)
        again = self.save("once.evidence")
        self.assertFalse(again.success)
        self.assertIn("overwrite", again.message)
        self.assertTrue(self.save("once", overwrite=True).success)

    def test_nothing_leaves_the_folder(self):
        for name in ("", "/tmp/belief", "../belief", "a/../../belief", "a/"):
            for answer in (self.save(name), self.load(name)):
                self.assertFalse(answer.success, name)
                self.assertIn("relative path", answer.message)

    def test_what_cannot_be_loaded_changes_nothing(self):
        self.learn()
        learnt = self.maps()
        self.assertTrue(self.save("damaged").success)
        file = os.path.join(below_ros_home(rospy.get_param(NODE + "/beliefs")), "damaged.evidence")
        with open(file, "r+b") as stream:
            stream.seek(300)
            stream.write(b"\n\n")
        for name in ("missing", "damaged"):
            answer = self.load(name)
            self.assertFalse(answer.success)
            self.assertIn(name + ".evidence", answer.message)
        self.assertEqual(self.maps(), learnt)

    def test_a_killed_node_that_is_started_again_has_the_same_maps_to_the_byte(self):
        self.learn()
        learnt = self.maps()
        killed = process_of(NODE)
        os.kill(killed, signal.SIGKILL)
        self.assertTrue(wait_until(lambda: process_of(NODE) not in (None, killed), 30.0))
        rospy.wait_for_service("load_belief", 30.0)
        self.assertEqual(self.maps(), learnt)

        def learns_on():  # once it is connected
            self.source.touch(0.03)
            return self.maps() != learnt

        self.assertTrue(wait_until(learns_on, 30.0))


if __name__ == "__main__":
    rostest.rosrun("smore", "kept_belief", KeptBelief)
