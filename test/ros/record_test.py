#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A record of what the listener was given makes the live maps again; other bags make maps with a warning."""

import os
import shutil
import subprocess
import tempfile
import threading
import unittest

import rosbag
import roslib.packages
import rosnode
import rospy
import rostest
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

from node_killing import CALLER, api_of
from node_testing import Recorder, WristSource, pose, start_node, transform, wait_until
from smore.msg import ContactObservation, EvidenceSource
from smore.srv import SaveMaps, TwinMaps, TwinMapsRequest

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "small_scene.yaml")
PRESS = (-6.0, 1.0, 0.0)  # [N]
LEVER = (0.0, 0.0, 0.5)  # [N m]


def record_file():
    home = os.environ.get("ROS_HOME", os.path.join(os.path.expanduser("~"), ".ros"))
    return os.path.join(home, rospy.get_param("force_torque/record"))


def feeds(talker, topic, listener):
    """Whether the node `talker` is connected on `topic` to the node `listener`."""
    return any(
        link[1] == listener and link[2] == "o" and link[4] == topic and link[5]
        for link in api_of(talker).getBusInfo(CALLER)[2]
    )


class Record(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("record_test")
        cls.folder = tempfile.mkdtemp()
        cls.live = os.path.join(cls.folder, "live")
        cls.bag = os.path.join(cls.folder, "run.bag")
        for service in ("twin_maps", "save_maps", "reset", "force_torque/tare"):
            rospy.wait_for_service(service, 30.0)
        cls.source = WristSource()
        cls.fixed = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        cls.fixed.publish(TFMessage([transform("object", "label", pose(), rospy.Time())]))
        contact = Recorder("contact", ContactObservation)
        assert contact.wait_for_publisher() and cls.source.wait_for_listener()
        assert wait_until(lambda: cls.fixed.get_num_connections() > 0)
        assert wait_until(lambda: feeds("force_torque", "/contact", "/mapping"))
        assert wait_until(lambda: feeds("mapping", "/evidence_source", "/force_torque"))
        cls.learn(contact)
        assert rospy.ServiceProxy("save_maps", SaveMaps)(cls.live).success
        rosnode.kill_nodes([rospy.resolve_name("force_torque")])
        assert wait_until(lambda: not os.path.exists(record_file() + ".active"))
        assert wait_until(lambda: cls.is_whole(record_file()))
        shutil.move(record_file(), cls.bag)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    @staticmethod
    def is_whole(file):
        try:
            with rosbag.Bag(file):
                return True
        except rosbag.ROSBagException:
            return False

    @classmethod
    def learn(cls, contact):
        """Touches that are forgotten, a tare with a bias, and touches that count."""
        cls.source.send_for(0.3)
        assert contact.wait_for(lambda message: message.state == ContactObservation.FREE)
        cls.touch(0.1, 0.0)
        cls.wait_for_maps(cls.source.send())
        source = Recorder("evidence_source", EvidenceSource)
        assert rospy.ServiceProxy("reset", Trigger)().success
        assert source.wait_for(lambda message: message.since > rospy.Time())
        cls.tare((1.0, 0.0, 0.0))
        for x, y in ((0.0, 0.0), (-0.05, 0.04), (0.05, -0.06)):
            stamp = cls.touch(x, y, bias=1.0)
        cls.wait_for_maps(stamp)

    @classmethod
    def touch(cls, x, y, bias=0.0):
        for step in range(1, 11):
            cls.source.send_for(0.01, at=pose(0.1 * step * x, 0.1 * step * y), force=(bias, 0.0, 0.0))
        pressed = (PRESS[0] + bias,) + PRESS[1:]
        cls.source.send_for(0.15, at=pose(x, y), force=pressed, torque=LEVER)
        return cls.source.send_for(0.1, at=pose(x, y), force=(bias, 0.0, 0.0))

    @classmethod
    def tare(cls, force):
        replies = []
        service = rospy.ServiceProxy("force_torque/tare", Trigger)
        caller = threading.Thread(target=lambda: replies.append(service()))
        caller.start()
        while caller.is_alive():
            cls.source.send(force=force)
            caller.join(0.001)
        assert replies[0].success, replies[0].message

    @staticmethod
    def wait_for_maps(stamp):
        request = TwinMapsRequest(not_before=stamp, timeout=rospy.Duration(20.0))
        assert rospy.ServiceProxy("twin_maps", TwinMaps)(request).success

    def rebuild(self, bag, *options):
        """Exit code, standard error and the folder of what was made."""
        output = tempfile.mkdtemp(dir=self.folder)
        program = roslib.packages.find_node("smore", "smore_rebuild")[0]
        command = [program, "--bag", bag, "--output", output, *options]
        done = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False, timeout=100)
        return done.returncode, done.stderr, output

    def filtered(self, name, keeps):
        file = os.path.join(self.folder, name)
        with rosbag.Bag(self.bag) as bag, rosbag.Bag(file, "w") as copy:
            for topic, message, time in bag.read_messages():
                if keeps(topic, time):
                    copy.write(topic, message, time)
        return file

    def test_it_makes_the_live_maps_again_to_the_byte(self):
        code, said, output = self.rebuild(self.bag)
        self.assertEqual(code, 0, said)
        self.assertEqual(said, "")
        for name in ("world.ot", "object.ot"):
            with open(os.path.join(self.live, name), "rb") as live:
                with open(os.path.join(output, name), "rb") as again:
                    maps = live.read()
                    self.assertGreater(len(maps), 200, "nothing was learnt")
                    self.assertEqual(maps, again.read())

    def test_it_holds_what_is_sensed_and_what_the_maps_follow_from(self):
        with rosbag.Bag(self.bag) as bag:
            topics = bag.get_type_and_topic_info()[1]
        for topic in ("/wrench", "/tf", "/sensing_events", "/evidence_source"):
            self.assertIn(topic, topics)

    def test_what_was_kept_for_who_came_late_is_kept_again_when_it_is_played(self):
        with rosbag.Bag(self.bag) as bag:
            latched = {link.topic for link in bag._get_connections() if link.header.get("latching") in ("1", b"1")}
        for topic in ("/tf_static", "/sensing_events", "/evidence_source"):
            self.assertIn(topic, latched)

    def test_a_bag_of_wrenches_and_transforms_alone_makes_maps_with_a_warning(self):
        bag = self.filtered("plain.bag", lambda topic, time: topic in ("/wrench", "/tf"))
        code, said, _ = self.rebuild(bag)
        self.assertEqual(code, 2)
        self.assertIn("--scenario", said)
        code, said, output = self.rebuild(bag, "--scenario", SCENE)
        self.assertEqual(code, 0, said)
        self.assertIn("warning", said)
        self.assertTrue(os.path.exists(os.path.join(output, "world.ot")))

    def test_a_bag_that_begins_too_late_says_so(self):
        with rosbag.Bag(self.bag) as bag:
            times = [time for _, _, time in bag.read_messages("/wrench")]
        bag = self.filtered("late.bag", lambda topic, time: topic != "/wrench" or time > times[20])
        code, said, _ = self.rebuild(bag)
        self.assertEqual(code, 0, said)
        self.assertIn("begins after the first wrench", said)

    def test_what_is_no_bag_is_refused(self):
        for bag, says in (
            (SCENE, "reindex"),
            ("/missing.bag", "missing.bag"),
            (self.filtered("none.bag", lambda topic, time: topic == "/tf"), "no wrench"),
        ):
            code, said, _ = self.rebuild(bag, "--scenario", SCENE)
            self.assertEqual(code, 2, said)
            self.assertIn(says, said)


if __name__ == "__main__":
    rostest.rosrun("smore", "record", Record)
