# SPDX-License-Identifier: BSD-3-Clause
"""What actionlib.SimpleActionClient leaves to a race: a transition that comes before its `send_goal` has returned is dropped,
so that its `wait_for_result` never hears of a goal that ends at once."""

from actionlib import CommState

from node_testing import DEADLINE, wait_until


def has_arrived(client):
    """Whether the server tells of the client's goal in time. A cancel before that may overtake the goal."""
    return wait_until(lambda: client.gh.get_comm_state() != CommState.WAITING_FOR_GOAL_ACK)


def has_ended(client, deadline=DEADLINE):
    """Whether the client's goal ends in time [s]; then its result is there."""
    return wait_until(lambda: client.gh.get_comm_state() == CommState.DONE, deadline)
