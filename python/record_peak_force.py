#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Listens to /wrench until SIGINT or SIGTERM, and writes the greatest force since the sensor was zeroed, as {"peak_force": N}.

    record_peak_force.py FILE

What is felt before the mean of 200 samples has come near zero is the weight of what the sensor carries.
"""
import collections
import json
import math
import sys

import rospy
from geometry_msgs.msg import WrenchStamped

AVERAGED = 200
NEAR_ZERO = 1.0  # [N]


class PeakForce:
    def __init__(self):
        self.value = 0.0  # [N]
        self._zeroed = False
        self._forces = collections.deque(maxlen=AVERAGED)

    def add(self, message):
        force = message.wrench.force
        force = (force.x, force.y, force.z)
        if self._zeroed:
            self.value = max(self.value, math.hypot(*force))
            return
        self._forces.append(force)
        mean = math.hypot(*(sum(axis) / AVERAGED for axis in zip(*self._forces)))
        self._zeroed = len(self._forces) == AVERAGED and mean < NEAR_ZERO


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: record_peak_force.py FILE")
    rospy.init_node("record_peak_force", anonymous=True)
    peak = PeakForce()
    rospy.Subscriber("/wrench", WrenchStamped, peak.add, tcp_nodelay=True)
    rospy.spin()
    with open(sys.argv[1], "w") as file:
        json.dump({"peak_force": peak.value}, file)


if __name__ == "__main__":
    main()
