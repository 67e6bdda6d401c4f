#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One master, two launches after one another: of the first nothing counts in the second."""

import pathlib
import signal
import subprocess
import tempfile
import unittest

import actionlib
import rospkg
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus

from action_clients import has_ended
from node_testing import DEADLINE, start_node, wait_until
from smore.msg import RetrieveAction, RetrieveGoal

TASK = rospkg.RosPack().get_path("smore") + "/config/tasks/ur5e.yaml"


class Launch:
    """roslaunch with these arguments, until the retrieval takes goals."""

    def __init__(self, *arguments):
        self._process = subprocess.Popen(["roslaunch", "smore", *arguments])
        self._client = actionlib.SimpleActionClient("smore/retrieve", RetrieveAction)
        assert self._client.wait_for_server(rospy.Duration(DEADLINE)), "no retrieval"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.send_signal(signal.SIGINT)
        self._process.wait()

    def begin_and_cancel(self):
        """How a goal ended that was cancelled once it had begun."""
        self._client.send_goal(RetrieveGoal())
        assert wait_until(lambda: self._client.get_state() == GoalStatus.ACTIVE)
        self._client.cancel_goal()
        assert has_ended(self._client)
        return self._client.get_state()


class Relaunch(unittest.TestCase):
    def test_a_second_launch_writes_nothing_over_the_results_of_the_first_and_calls_none_of_its_services(self):
        start_node("relaunch_test")
        robot = ["robot.launch", f"scenario:={TASK}", "rviz:=false"]
        with tempfile.TemporaryDirectory() as folder:
            summary = pathlib.Path(folder, "summary.json")
            with Launch(*robot, f"output:={folder}", "zero_service:=/gone/zero", "max_collisions:=3") as first:
                self.assertEqual(rospy.get_param("/smore/retrieval/zero_service"), "/gone/zero")
                self.assertEqual(first.begin_and_cancel(), GoalStatus.PREEMPTED)
                self.assertTrue(wait_until(summary.is_file))
            summary.write_text("kept", encoding="ascii")
            rospy.set_param("/use_sim_time", True)  # as a simulation leaves it
            with Launch(*robot, "zero_service:=none") as second:
                self.assertFalse(rospy.get_param("/use_sim_time"))
                for name in ("output", "zero_service"):
                    self.assertFalse(rospy.has_param("/smore/retrieval/" + name), name)
                self.assertEqual(rospy.get_param("/smore/retrieval/max_collisions"), 100)
                self.assertEqual(second.begin_and_cancel(), GoalStatus.PREEMPTED)
            self.assertEqual(summary.read_text(encoding="ascii"), "kept")


if __name__ == "__main__":
    rostest.rosrun("smore", "relaunch_test", Relaunch)
