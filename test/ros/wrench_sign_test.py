#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A wrench of the wrong sign ends the retrieval at the first touch, which says so."""

import unittest

import rostest

from node_testing import start_node
from retrieve_client import RetrieveClient


class WrenchSign(unittest.TestCase):
    def test_the_first_touch_ends_the_goal_with_the_parameter_that_fits(self):
        start_node("wrench_sign_test")
        result = RetrieveClient().retrieve()
        self.assertFalse(result.success)
        self.assertIn("(wrench_sign: -1)", result.message)


if __name__ == "__main__":
    rostest.rosrun("smore", "wrench_sign_test", WrenchSign)
