#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The listener alone, on generated wrenches and transforms."""

import math
import threading
import unittest

import rospy
import rostest
from geometry_msgs.msg import WrenchStamped
from std_srvs.srv import Trigger

from node_testing import (
    DEADLINE,
    Recorder,
    Warnings,
    WristSource,
    pose,
    start_node,
    transform,
    wait_until,
)
from smore.msg import ContactObservation
from tf2_msgs.msg import TFMessage


class ForceTorqueNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("force_torque_node_test")
        cls.contact = Recorder("contact", ContactObservation)
        cls.warnings = Warnings(rospy.resolve_name("force_torque"))
        cls.source = WristSource()
        assert cls.contact.wait_for_publisher() and cls.source.wait_for_listener()
        assert cls.warnings.wait_for_publisher()
        cls.source.send_for(0.3)
        assert cls.wait_for_state(ContactObservation.FREE), "not tared by itself at the start"

    @classmethod
    def wait_for_state(cls, state):
        return cls.contact.wait_for(lambda observation: observation.state == state)

    def setUp(self):
        self.feed(0.1)
        self.contact.clear()

    def is_answered(self, stamp, answers=None):
        return (answers or self.contact).wait_for(lambda message: message.header.stamp == stamp)

    def feed(self, duration, **sample):
        """Samples for so long, no faster than they are answered: no sensor sends seconds of them at once. The last
        answer."""
        for _ in range(int(round(duration / 0.1))):
            answer = self.is_answered(self.source.send_for(0.1, **sample))
            self.assertIsNotNone(answer)
        return answer

    def touch(self, force, torque, at=None, frame="object"):
        """The observation with the line of a contact; the contact is over when it returns."""
        self.source.send_for(0.1, force=force, torque=torque, at=at, frame=frame)
        self.source.send_for(0.1, at=at)
        observation = self.contact.wait_for(lambda message: message.has_line)
        self.assertIsNotNone(observation, "no line of a contact of 0.1 s")
        return observation

    def tare(self, **sample):
        """The reply to a tare while such samples come."""
        return self.ask("tare", **sample)

    def ask(self, name, **sample):
        """The reply to a service of the listener while such samples come."""
        replies = []
        service = rospy.ServiceProxy("force_torque/" + name, Trigger)
        caller = threading.Thread(target=lambda: replies.append(service()))
        caller.start()
        while caller.is_alive():
            self.source.send(**sample)
            caller.join(0.001)
        return replies[0]

    def test_each_sample_is_answered_with_its_own_stamp_and_pose(self):
        stamps = [self.source.send(at=pose(0.001 * i, 0.2)) for i in range(50)]
        self.assertTrue(self.contact.wait_for(lambda message: message.header.stamp == stamps[-1]))
        answers = self.contact.messages()
        self.assertEqual([answer.header.stamp for answer in answers], stamps)
        for i, answer in enumerate(answers):
            self.assertAlmostEqual(answer.pose.position.x, 0.001 * i, 9)
            self.assertEqual(answer.header.frame_id, "object")
            self.assertEqual(answer.world_frame, "world")

    def test_answers_carry_the_stamp_to_the_nanosecond(self):
        compensated = Recorder("wrench_compensated", WrenchStamped)
        # A publisher that is known may not know the subscriber yet.
        self.assertTrue(wait_until(lambda: self.source.send() and compensated.messages()))
        last = self.source.send()
        for answers in (self.contact, compensated):
            self.assertTrue(self.is_answered(last, answers))
            answers.clear()
        # Of today and odd: seconds in a double are good to a quarter of a microsecond only.
        begin = rospy.Time(1800000000, 123456789)
        stamps = [begin + rospy.Duration(0, 2000000 * i + 37 * i * i % 49999) for i in range(1000)]
        for i, stamp in enumerate(stamps):
            self.source.send(stamp=stamp)
            if i % 50 == 49:
                self.assertTrue(self.is_answered(stamp))
        self.source.time = stamps[-1].to_sec()
        for answers in (self.contact, compensated):
            self.assertTrue(self.is_answered(stamps[-1], answers))
            self.assertTrue([answer.header.stamp for answer in answers.messages()] == stamps)

    def test_a_message_that_comes_again_is_told_once_and_answered_once(self):
        first = rospy.Time.from_sec(self.source.time + 0.002)
        for _ in range(500):
            self.source.send(stamp=first, force=(0, 0, 30))
        last = self.source.send_for(0.1)
        self.assertTrue(self.contact.wait_for(lambda message: message.header.stamp == last))
        answers = self.contact.messages()
        self.assertEqual([answer.header.stamp for answer in answers].count(first), 1)
        self.assertEqual(answers[-1].state, ContactObservation.FREE)
        self.assertTrue(self.warnings.wait_for("it is not newer than the one before"))
        self.assertLess(len(self.warnings.texts("it is not newer than the one before")), 5)

    def test_a_frame_that_tf_cannot_know_is_named_once(self):
        for frame, words in (("", "is empty"), ("/object", "begins with '/'")):
            # Each kind of drop is told every few seconds.
            def told(frame=frame, words=words):
                self.source.send(frame=frame)
                return self.warnings.texts(words)

            self.assertTrue(wait_until(told), words)
            self.assertLess(len(told()), 5)
        stamp = self.source.send_for(0.1)
        self.assertTrue(self.contact.wait_for(lambda message: message.header.stamp == stamp))

    def test_a_rate_far_from_what_the_parameters_say_is_told(self):
        for _ in range(300):
            self.source.time += 0.006
            self.source.send()
        self.assertTrue(self.warnings.wait_for("noise/sample_period says 0.002 s"))

    def test_the_line_is_the_papers(self):
        # 10 N along -y at the point (0.3, 0, 0): the torque is r x F = (0, 0, -3).
        line = self.touch((0, -10, 0), (0, 0, -3)).line
        self.assertAlmostEqual(line.force, 10.0, 6)
        self.assertAlmostEqual(line.pitch, 0.0, 6)
        self.assertAlmostEqual(line.direction.y, -1.0, 6)
        self.assertAlmostEqual(line.point.x, 0.3, 6)
        self.assertAlmostEqual(line.point.y, 0.0, 6)

    def test_each_contact_gives_one_line_and_a_new_id(self):
        first = self.touch((0, -10, 0), (0, 0, 0))
        second_id = first.contact_id + 1
        self.source.send_for(0.2, force=(0, 10, 0))
        self.assertTrue(self.contact.wait_for(lambda message: message.contact_id == second_id))
        stamp = self.source.send_for(0.1)
        self.assertTrue(self.contact.wait_for(lambda message: message.header.stamp == stamp))
        lines = [message for message in self.contact.messages() if message.has_line]
        self.assertEqual([message.contact_id for message in lines], [first.contact_id, second_id])

    def test_a_wrench_of_another_frame_is_moved_into_the_object_frame(self):
        # The sensor stands at (0, 0.5, 0) of the object, turned by a quarter about z: its x is the
        # object's y. A force of 10 N along its x at its own origin is along y through (0, 0.5, 0).
        mount = transform("object", "sensor", pose(0.0, 0.5, math.pi / 2), rospy.Time())
        static = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        static.publish(TFMessage([mount]))
        self.assertTrue(wait_until(lambda: static.get_num_connections() > 0))
        line = self.touch((10, 0, 0), (0, 0, 0), frame="sensor").line
        self.assertAlmostEqual(line.direction.y, 1.0, 6)
        self.assertAlmostEqual(line.point.x, 0.0, 6)

    def test_a_wrench_that_is_not_finite_says_nothing_and_harms_nothing(self):
        for bad in (math.nan, math.inf):
            stamp = self.source.send(force=(bad, 0, 0))
            answer = self.contact.wait_for(lambda message: message.header.stamp == stamp)
            self.assertEqual(answer.state, ContactObservation.UNSURE)
            self.assertFalse(answer.has_line)
        self.assertAlmostEqual(self.touch((0, 0, 8), (0, 0, 0)).line.force, 8.0, 6)

    def test_a_wrench_without_a_pose_is_dropped_and_later_ones_come_through(self):
        self.source.time += 20.0  # away from the poses of before
        lost = self.source.send_for(0.02, with_pose=False, frame="nowhere")
        last = self.source.send_for(1.0)
        self.assertTrue(self.contact.wait_for(lambda message: message.header.stamp == last))
        self.assertNotIn(lost, [message.header.stamp for message in self.contact.messages()])

    def test_tare_takes_what_is_felt_now_for_nothing(self):
        compensated = Recorder("wrench_compensated", WrenchStamped)
        self.assertTrue(compensated.wait_for_publisher())
        reply = self.tare(force=(3, 0, 0))
        self.assertTrue(reply.success, reply.message)
        compensated.clear()
        stamp = self.source.send_for(0.05, force=(3, 0, 0))
        felt = compensated.wait_for(lambda message: message.header.stamp == stamp)
        self.assertAlmostEqual(felt.wrench.force.x, 0.0, 6)
        reply = self.tare()
        self.assertTrue(reply.success, reply.message)

    def test_tare_while_something_presses_is_refused_and_spoils_nothing(self):
        self.source.send_for(0.1, force=(0, 0, 12))
        reply = self.tare(force=(0, 0, 12))
        self.assertFalse(reply.success)
        self.assertIn("presses with 12 N", reply.message)
        stamp = self.source.send_for(0.1)
        answer = self.contact.wait_for(lambda message: message.header.stamp == stamp)
        self.assertEqual(answer.state, ContactObservation.FREE)
        contacts = {message.contact_id for message in self.contact.messages()}
        self.assertEqual(len(contacts), 2, "one before it pressed, one since")

    def test_a_zeroing_that_was_announced_is_no_contact(self):
        stamp = self.source.send_for(0.05)
        self.assertTrue(self.contact.wait_for(lambda message: message.header.stamp == stamp))
        self.contact.clear()
        self.assertTrue(self.ask("suspend").success)
        self.source.send_for(0.5, force=(0, 0, 12))
        self.assertTrue(self.tare(force=(0, 0, 12)).success)
        stamp = self.source.send_for(0.1, force=(0, 0, 12))
        answer = self.contact.wait_for(lambda message: message.header.stamp == stamp)
        self.assertEqual(answer.state, ContactObservation.FREE)
        self.assertNotIn(ContactObservation.CONTACT, {message.state for message in self.contact.messages()})
        self.assertTrue(self.ask("suspend", force=(0, 0, 12)).success)
        self.source.send_for(0.1)
        self.assertTrue(self.tare().success)

    def test_a_suspension_that_nobody_ends_is_ended_by_a_tare(self):
        self.assertTrue(self.ask("suspend").success)
        self.source.send_for(2.5, force=(0, 0, 12))
        self.contact.clear()
        stamp = self.source.send_for(1.0, force=(0, 0, 12))
        answer = self.contact.wait_for(lambda message: message.header.stamp == stamp)
        self.assertEqual(answer.state, ContactObservation.FREE)
        self.assertEqual(self.contact.messages()[0].state, ContactObservation.UNSURE)
        self.assertTrue(self.ask("suspend", force=(0, 0, 12)).success)
        self.source.send_for(0.1)
        self.assertTrue(self.tare().success)

    def test_a_suspension_while_something_presses_that_is_no_weight_is_refused(self):
        self.source.send_for(0.1, force=(12, 0, 0))
        reply = self.ask("suspend", force=(12, 0, 0))
        self.assertFalse(reply.success)
        self.assertIn("presses with 12 N", reply.message)
        stamp = self.source.send_for(0.1)
        answer = self.contact.wait_for(lambda message: message.header.stamp == stamp)
        self.assertEqual(answer.state, ContactObservation.FREE)

    def test_what_the_gripper_keeps_after_a_touch_is_told_and_taken_off(self):
        self.feed(0.3)
        self.feed(0.1, force=(0, 0, 12))
        answer = self.feed(1.5, force=(0, 0, 2.9))
        self.assertEqual(answer.state, ContactObservation.FREE)
        self.assertTrue(self.warnings.wait_for("the gripper keeps 2.9 N"))
        self.contact.clear()
        self.assertAlmostEqual(self.touch((0, -10, 2.9), (0, 0, 0)).line.direction.y, -1.0, 6)
        self.assertTrue(self.tare().success)

    def test_tare_with_a_silent_sensor_says_so(self):
        answer = rospy.ServiceProxy("force_torque/tare", Trigger)()
        self.assertFalse(answer.success)
        self.assertIn("wrenches", answer.message)
        # The request is still open: the next samples serve it.
        self.source.send_for(0.4)
        self.assertTrue(self.wait_for_state(ContactObservation.FREE))

    def test_a_stamp_at_the_end_of_time_ends_nothing(self):
        for with_pose in (False, True):
            self.source.send(stamp=rospy.Time(2**32 - 1), with_pose=with_pose)
            answer = self.is_answered(self.source.send_for(0.5))
            self.assertIsNotNone(answer)
            self.assertEqual(answer.state, ContactObservation.FREE)

    def test_stamps_that_stray_change_nothing_also_under_load(self):
        self.feed(0.3, force=(0, 0, 12))
        for ahead in (3600.0, -3600.0):
            for with_pose in (False, True):
                stamp = rospy.Time.from_sec(self.source.time + ahead)
                self.source.send(stamp=stamp, with_pose=with_pose, force=(0, 0, 12))
                self.assertEqual(self.feed(0.3, force=(0, 0, 12)).state, ContactObservation.CONTACT)
                self.assertNotIn(stamp, [message.header.stamp for message in self.contact.messages()])
        self.assertTrue(self.warnings.wait_for("its stamp is seconds from those before and after it"))
        touching = [message for message in self.contact.messages() if message.state == ContactObservation.CONTACT]
        self.assertEqual(len({message.contact_id for message in touching}), 1)

    def test_a_sample_after_a_leap_is_answered_though_none_follows(self):
        self.source.time += 30.0
        self.assertIsNotNone(self.is_answered(self.source.send()))

    def test_time_that_goes_back_begins_anew(self):
        self.source.time = 0.5
        stamp = self.source.send_for(0.5)
        answer = self.contact.wait_for(lambda message: message.header.stamp == stamp, DEADLINE)
        self.assertIsNotNone(answer)
        self.assertEqual(answer.state, ContactObservation.FREE)


if __name__ == "__main__":
    rostest.rosrun("smore", "force_torque_node_test", ForceTorqueNode)
