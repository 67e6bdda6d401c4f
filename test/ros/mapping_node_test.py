#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The mapping alone, on generated observations."""

import math
import os
import struct
import tempfile
import threading
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.client import Client
from octomap_msgs.msg import Octomap, OctomapWithPose
from octomap_msgs.srv import GetOctomap
from sensor_msgs.msg import PointCloud2
from std_msgs.msg import Float64
from std_srvs.srv import Trigger
from visualization_msgs.msg import MarkerArray

from node_testing import DEADLINE, Recorder, start_node, wait_until
from observations import ObservationSource
from smore.msg import ContactObservation
from smore.srv import SaveMaps, TwinMaps, TwinMapsRequest

SERVICES = ["twin_maps", "reset", "save_maps", "world/octomap_full", "object/octomap_binary"]


def shows_voxels(array):
    return any(marker.points for marker in array.markers)


def length_of(array):
    """Of the first line of action among markers [m]; 0 where there is none."""
    ends = array.markers[0].points[:2] if array.markers else []
    return math.dist(*((end.x, end.y, end.z) for end in ends)) if len(ends) == 2 else 0.0


class MappingNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        start_node("mapping_node_test")
        for service in SERVICES:
            rospy.wait_for_service(service, 30.0)
        cls.source = ObservationSource()
        assert cls.source.wait_for_listener()
        cls.twin_maps = rospy.ServiceProxy("twin_maps", TwinMaps)

    def setUp(self):
        self.assertTrue(rospy.ServiceProxy("reset", Trigger)().success)

    def maps_at(self, stamp, timeout=20.0):
        request = TwinMapsRequest(not_before=stamp, timeout=rospy.Duration(timeout))
        request.with_octrees = request.with_evidence = True
        return self.twin_maps(request)

    def test_maps_hold_what_was_felt_up_to_the_time_asked_for(self):
        stamp = self.source.touch()
        maps = self.maps_at(stamp)
        self.assertTrue(maps.success, maps.message)
        self.assertGreaterEqual(maps.stamp, stamp)
        self.assertEqual(maps.world.header.stamp, maps.stamp)
        self.assertEqual(maps.world.header.frame_id, "world")
        self.assertEqual(maps.object.header.frame_id, "object")
        self.assertEqual(maps.world.id, "OcTree")
        self.assertAlmostEqual(maps.world.resolution, 0.03)
        self.assertGreater(len(maps.world.data), 0)
        self.assertGreater(len(maps.object.data), 0)
        self.assertTrue(any(entry.has_line for entry in maps.evidence.observations))

    def test_maps_of_a_time_to_come_are_refused(self):
        later = rospy.Time.from_sec(self.source.time + 100.0)
        maps = self.maps_at(later, timeout=0.1)
        self.assertFalse(maps.success)
        self.assertIn("up to the time", maps.message)

    def test_callers_that_wait_hold_up_nobody_else(self):
        stamp = self.maps_at(self.source.touch()).stamp
        request = TwinMapsRequest(not_before=stamp + rospy.Duration(1.0), timeout=rospy.Duration(60.0))
        answers = []
        wait = lambda: answers.append(rospy.ServiceProxy("twin_maps", TwinMaps)(request))
        callers = [threading.Thread(target=wait, daemon=True) for _ in range(8)]
        for caller in callers:
            caller.start()
        self.assertTrue(wait_until(lambda: answers), "seven wait, and one more is refused")
        self.assertIn("7 callers wait already", answers[0].message)
        self.assertTrue(self.maps_at(stamp).success)
        self.assertEqual(rospy.ServiceProxy("world/octomap_full", GetOctomap)().map.header.stamp, stamp)
        diagnostics = Recorder("/diagnostics", DiagnosticArray)
        self.addCleanup(diagnostics.close)
        told = lambda array: any(status.name == "mapping: maps" for status in array.status)
        self.assertIsNotNone(diagnostics.wait_for(told))
        self.source.stay(1.1)
        for caller in callers:
            caller.join()
        self.assertEqual([bool(answer.success) for answer in answers], [False] + 7 * [True])

    def test_evidence_comes_in_parts_and_anew_after_a_reset(self):
        first = self.maps_at(self.source.touch()).evidence
        request = TwinMapsRequest(not_before=self.source.touch(), timeout=rospy.Duration(20.0))
        request.with_evidence = True
        request.epoch = first.epoch
        request.evidence_from = len(first.observations)
        second = self.twin_maps(request).evidence
        self.assertEqual(second.first, len(first.observations))
        self.assertGreater(len(second.observations), 0)
        rospy.ServiceProxy("reset", Trigger)()
        third = self.twin_maps(request).evidence
        self.assertNotEqual(third.epoch, first.epoch)
        self.assertEqual(third.first, 0)

    def test_repeated_free_samples_add_no_evidence(self):
        self.source.stay(0.5)
        evidence = self.maps_at(self.source.stay(0.5)).evidence
        self.assertEqual(len(evidence.observations), 1)

    def test_octomaps_come_by_service_and_latched_topic(self):
        stamp = self.source.touch()
        self.assertTrue(self.maps_at(stamp).success)
        for space in ("world", "object"):
            for kind, binary in (("octomap_full", False), ("octomap_binary", True)):
                name = space + "/" + kind
                served = rospy.ServiceProxy(name, GetOctomap)().map
                self.assertEqual(served.header.frame_id, space)
                self.assertEqual(bool(served.binary), binary)
                topic = Recorder(name, Octomap)
                published = topic.wait_for(lambda message, s=served: message.data == s.data)
                self.assertIsNotNone(published, name)
                self.assertEqual(published.header.stamp, served.header.stamp)
                topic.close()

    def test_octomaps_come_with_the_pose_that_planning_scenes_ask_for(self):
        self.assertTrue(self.maps_at(self.source.touch()).success)
        for space in ("world", "object"):
            served = rospy.ServiceProxy(space + "/octomap_full", GetOctomap)().map
            topic = Recorder(space + "/octomap_with_pose", OctomapWithPose)
            self.addCleanup(topic.close)
            posed = topic.wait_for(lambda message, s=served: message.octomap.data == s.data)
            self.assertIsNotNone(posed, space)
            self.assertEqual(posed.header.frame_id, space)
            self.assertEqual(posed.origin.orientation.w, 1.0)

    def test_the_likeliest_voxels_come_as_cloud_and_markers(self):
        self.maps_at(self.source.touch())
        self.maps_at(self.source.touch(x=0.3))  # a second line crosses the first one in the object
        cells = Recorder("object/occupied_cells_vis_array", MarkerArray)
        cloud = Recorder("object/octomap_point_cloud_centers", PointCloud2)
        lines = Recorder("contact_lines", MarkerArray)
        self.assertIsNotNone(cells.wait_for(lambda array: array.markers))
        message = cloud.wait_for(lambda _: True)
        self.assertEqual([field.name for field in message.fields], ["x", "y", "z", "intensity"])
        for i in range(message.width * message.height):
            probability = struct.unpack_from("<f", message.data, i * message.point_step + 12)[0]
            self.assertGreaterEqual(probability, 0.5)
        both = lines.wait_for(lambda array: len(array.markers[0].points) == 4)
        self.assertIsNotNone(both, "two lines are two pairs of points")

    def test_voxels_are_shown_from_the_probability_that_is_wished(self):
        self.maps_at(self.source.touch())
        wish = rospy.Publisher("shown_probability", Float64, queue_size=1, latch=True)
        cells = Recorder("object/occupied_cells_vis_array", MarkerArray)
        self.addCleanup(cells.close)
        counts = []
        for probability in (0.001, 1.0):
            cells.clear()
            wish.publish(probability)
            many = probability < 0.5
            counts.append(cells.wait_for(lambda array, many=many: shows_voxels(array) == many))
        wish.publish(7.0)  # no probability: it stays as it is
        wish.publish(0.3)
        self.assertNotIn(None, counts)

    def test_what_is_shown_changes_while_it_runs(self):
        self.maps_at(self.source.touch())
        display = Client("mapping", timeout=DEADLINE)
        self.addCleanup(display.close)
        self.addCleanup(display.update_configuration, {"display_min_probability": 0.3, "line_half_length": 1.0})
        cells = Recorder("object/occupied_cells_vis_array", MarkerArray)
        lines = Recorder("contact_lines", MarkerArray)
        for recorder in (cells, lines):
            self.addCleanup(recorder.close)
        for probability, many in ((0.001, True), (1.0, False)):
            display.update_configuration({"display_min_probability": probability})
            self.assertTrue(cells.wait_for(lambda array, many=many: shows_voxels(array) == many))
            cells.clear()
        for half_length in (0.2, 0.7):
            display.update_configuration({"line_half_length": half_length})
            self.assertTrue(lines.wait_for(lambda array, h=half_length: abs(length_of(array) - 2 * h) < 1e-6))
        in_force = display.update_configuration({"display_min_probability": 7.0, "line_half_length": 0.5})
        self.assertEqual((in_force.display_min_probability, in_force.line_half_length), (1.0, 0.5))

    def test_a_probability_that_is_wished_on_the_topic_is_told_to_all(self):
        display = Client("mapping", timeout=DEADLINE)
        self.addCleanup(display.close)
        wish = rospy.Publisher("shown_probability", Float64, queue_size=1, latch=True)
        self.addCleanup(wish.unregister)
        for probability in (0.6, 0.3):
            wish.publish(probability)
            told = lambda p=probability: display.get_configuration(DEADLINE).display_min_probability == p
            self.assertTrue(wait_until(told))

    def test_reset_empties_the_maps(self):
        self.assertGreater(len(self.maps_at(self.source.touch()).world.data), 0)
        self.assertTrue(rospy.ServiceProxy("reset", Trigger)().success)
        self.assertEqual(len(rospy.ServiceProxy("world/octomap_full", GetOctomap)().map.data), 0)

    def test_maps_are_saved_where_they_are_wanted(self):
        self.maps_at(self.source.touch())
        save = rospy.ServiceProxy("save_maps", SaveMaps)
        with tempfile.TemporaryDirectory() as directory:
            wanted = os.path.join(directory, "new", "maps")
            answer = save(wanted)
            self.assertTrue(answer.success, answer.message)
            for name in ("world.ot", "object.ot"):
                with open(os.path.join(wanted, name), "rb") as file:
                    self.assertTrue(file.read().startswith(b"# Octomap OcTree file"))
            blocked = os.path.join(directory, "file")
            with open(blocked, "w", encoding="ascii"):
                pass
            self.assertFalse(save(blocked).success)
        self.assertFalse(save("relative/path").success)

    def test_bad_observations_are_left_out(self):
        good = self.maps_at(self.source.touch())
        for spoil in (
            lambda message: setattr(message.pose.position, "x", math.nan),
            lambda message: setattr(message, "world_frame", "base"),
            lambda message: setattr(message.header, "frame_id", "hand"),
            lambda message: setattr(message, "state", 9),
            lambda message: setattr(message.line.direction, "x", math.inf),
        ):
            message = self.source.next(ContactObservation.CONTACT, x=0.2, line=True)
            message.contact_id += 1
            spoil(message)
            self.source.publish(message)
        after = self.maps_at(self.source.stay(0.01))
        self.assertEqual(after.world.data, good.world.data)
        self.assertEqual(after.object.data, good.object.data)


if __name__ == "__main__":
    rostest.rosrun("smore", "mapping_node_test", MappingNode)
