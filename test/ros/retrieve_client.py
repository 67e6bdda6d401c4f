# SPDX-License-Identifier: BSD-3-Clause
"""The user's side of the action `retrieve`."""

import math

import actionlib

from action_clients import has_ended
from smore.msg import RetrieveAction, RetrieveGoal


class RetrieveClient:
    """Connected to the retrieval node. The test's time limit ends what waits too long."""

    def __init__(self):
        self._client = actionlib.SimpleActionClient("retrieve", RetrieveAction)
        self._client.wait_for_server()

    def retrieve(self, on_feedback=None, goal=None):
        """One retrieval to `goal` or else to that of the scenario; its result."""
        self._client.send_goal(goal or RetrieveGoal(), feedback_cb=on_feedback)
        has_ended(self._client, math.inf)
        return self._client.get_result()
