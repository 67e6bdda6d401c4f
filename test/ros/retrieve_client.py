# SPDX-License-Identifier: BSD-3-Clause
"""The user's side of the action `retrieve`."""

import actionlib

from smore.msg import RetrieveAction, RetrieveGoal


class RetrieveClient:
    """Connected to the retrieval node. The test's time limit ends what waits too long."""

    def __init__(self):
        self._client = actionlib.SimpleActionClient("retrieve", RetrieveAction)
        self._client.wait_for_server()

    def retrieve(self, on_feedback=None, goal=None):
        """One retrieval to `goal` or else to that of the scenario; its result."""
        self._client.send_goal(goal or RetrieveGoal(), feedback_cb=on_feedback)
        self._client.wait_for_result()
        return self._client.get_result()
