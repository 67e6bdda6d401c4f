#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""In a simulation without a guard the arm stops with who commands it."""

import signal

import rostest

from node_killing import KillingTest


class KilledCommander(KillingTest):
    GUARD = False

    def test_the_retrieval_is_killed(self):
        self.stands_after(self.loop.signal, "retrieval", signal.SIGKILL)

    def test_the_retrieval_is_interrupted(self):
        self.stands_after(self.loop.signal, "retrieval", signal.SIGINT)

    def test_the_listener_is_killed(self):
        self.stands_after(self.loop.signal, "force_torque", signal.SIGKILL)


if __name__ == "__main__":
    rostest.rosrun("smore", "killed_commander", KilledCommander)
