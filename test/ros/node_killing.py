# SPDX-License-Identifier: BSD-3-Clause
"""Nodes that are started, and ended while they move the arm of a running simulator."""

import os
import signal
import subprocess
import unittest
import xmlrpc.client

import actionlib
import rosgraph
import rospy
from sensor_msgs.msg import JointState
from std_srvs.srv import Trigger

from node_testing import DEADLINE, Recorder, start_node
from smore.msg import RetrieveAction, RetrieveGoal

CALLER = "/node_killing"
LAUNCH_FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "robot_loop.launch")
MOVES = 0.05  # a joint that moves is faster [rad/s]
STANDS = 2e-3  # a joint that stands is slower [rad/s]
WATCHED = 1.0  # after the end of a node [s of the arm's own time]
# From the end of a node to the arm's rest [s of the arm's own time]: 0.3 s by design, and what a machine that is busy with
# other tests takes to end a process and to tell so.
MOST = 0.5


def speed(joints):
    """Of the fastest joint [rad/s]."""
    return max(abs(velocity) for velocity in joints.velocity)


def api_of(node):
    """What each node offers to others."""
    return xmlrpc.client.ServerProxy(rosgraph.Master(CALLER).lookupNode(rospy.resolve_name(node)))


class Simulator:
    """The arm, which outlives the nodes."""

    def __init__(self):
        self.joints = Recorder("/joint_states", JointState)
        assert self.joints.wait_for_publisher()
        rospy.wait_for_service("simulator/reset", DEADLINE)
        self.reset = rospy.ServiceProxy("simulator/reset", Trigger)

    def wait_for_motion(self):
        self.joints.clear()
        return self.joints.wait_for(lambda state: speed(state) > MOVES)

    def rest_after(self, end_node):
        """Calls `end_node`; how long the arm moved from then on [s of its own time]."""
        begin = self.joints.messages()[-1].header.stamp.to_sec()
        end_node()
        end = begin + WATCHED
        assert self.joints.wait_for(lambda m: m.header.stamp.to_sec() > end), "no joint states"
        states = [m for m in self.joints.messages() if m.header.stamp.to_sec() > begin]
        moving = [m.header.stamp.to_sec() - begin for m in states if speed(m) > STANDS]
        return moving[-1] if moving else 0.0


class KillingTest(unittest.TestCase):
    """A retrieval that moves the arm, behind a guard or not, as the derived class says."""

    GUARD = None

    @classmethod
    def setUpClass(cls):
        start_node("killing_test")
        cls.simulator = Simulator()

    def setUp(self):
        self.assertTrue(self.simulator.reset().success)
        self.loop = RunningLoop("ur5e_one_peg_quiet", self.GUARD)
        self.addCleanup(self.loop.end)
        self.assertTrue(self.simulator.wait_for_motion())

    def stands_after(self, end_node, *arguments):
        self.assertLess(self.simulator.rest_after(lambda: end_node(*arguments)), MOST)


class RunningLoop:
    """All nodes but the robot's, with a goal, in the namespace of the test."""

    def __init__(self, scenario, guard):
        arguments = [f"scenario:={scenario}", f"guard:={str(guard).lower()}"]
        self.launch = subprocess.Popen(["roslaunch", LAUNCH_FILE, *arguments])
        self._client = actionlib.SimpleActionClient("retrieve", RetrieveAction)
        assert self._client.wait_for_server(rospy.Duration(DEADLINE)), "no retrieval"
        self._client.send_goal(RetrieveGoal())

    def end(self):
        self.launch.send_signal(signal.SIGINT)
        self.launch.wait()

    @staticmethod
    def signal(node, which):
        os.kill(api_of(node).getPid(CALLER)[2], which)

    @staticmethod
    def ask_to_end(node):
        """As `rosnode kill` does."""
        api_of(node).shutdown(CALLER, "by a test")
