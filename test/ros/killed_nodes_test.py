#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever node ends in a motion behind the guard, and however, the arm comes to rest."""

import signal

import rostest

from node_killing import KillingTest


class KilledNodes(KillingTest):
    GUARD = True

    def test_the_guard_is_killed(self):
        self.stands_after(self.loop.signal, "guard", signal.SIGKILL)

    def test_the_guard_is_interrupted(self):
        self.stands_after(self.loop.signal, "guard", signal.SIGINT)

    def test_the_retrieval_is_killed(self):
        self.stands_after(self.loop.signal, "retrieval", signal.SIGKILL)

    def test_the_retrieval_is_asked_to_end(self):
        self.stands_after(self.loop.ask_to_end, "retrieval")

    def test_the_guard_is_asked_to_end(self):
        self.stands_after(self.loop.ask_to_end, "guard")

    def test_the_listener_is_killed(self):
        self.stands_after(self.loop.signal, "force_torque", signal.SIGKILL)

    def test_the_mapping_is_killed(self):
        self.stands_after(self.loop.signal, "mapping", signal.SIGKILL)

    def test_the_planner_is_killed(self):
        self.stands_after(self.loop.signal, "planner", signal.SIGKILL)

    def test_the_launch_is_interrupted(self):
        self.stands_after(self.loop.launch.send_signal, signal.SIGINT)

    def test_all_nodes_are_killed_at_once(self):
        def kill_all():
            for node in ["guard", "retrieval", "force_torque", "mapping", "planner"]:
                self.loop.signal(node, signal.SIGKILL)

        self.stands_after(kill_all)


if __name__ == "__main__":
    rostest.rosrun("smore", "killed_nodes", KilledNodes)
