#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Launches a retrieval at a real-time factor of 1 and measures the sensor's rate while it runs.

    real_time.py SCENARIO      (in the environment of the build, with ROS_MASTER_URI on a free port)
"""
import os
import resource
import subprocess
import sys
import threading
import time
import urllib.parse

import rospy
from geometry_msgs.msg import WrenchStamped

RATE = 500.0  # of the sensor [Hz]
MASTER_TIMEOUT = 30.0  # [s]


class Stream:
    """Stamps of the wrenches against the clock on the wall."""

    def __init__(self):
        self.lock = threading.Lock()
        self.arrivals = []  # (wall time, stamp), both [s]

    def add(self, message):
        with self.lock:
            self.arrivals.append((time.monotonic(), message.header.stamp.to_sec()))

    def report(self):
        if len(self.arrivals) < RATE:
            sys.exit("real_time: no wrenches came; see the messages above")
        (wall_begin, stamp_begin), (wall_end, stamp_end) = self.arrivals[0], self.arrivals[-1]
        wall, simulated = wall_end - wall_begin, stamp_end - stamp_begin
        lags = [
            (arrival - wall_begin) - (stamp - stamp_begin) for arrival, stamp in self.arrivals
        ]
        print(f"simulated {simulated:.1f} s in {wall:.1f} s: real-time factor {simulated / wall:.3f}")
        print(f"wrenches: {len(self.arrivals) / wall:.0f} a second of {RATE:.0f}")
        print(f"behind real time: {max(lags):.3f} s at most, {lags[-1]:.3f} s at the end")


def wait_for_master():
    deadline = time.monotonic() + MASTER_TIMEOUT
    while not rospy.core.is_initialized():
        try:
            rospy.get_master().getPid()
            rospy.init_node("real_time", anonymous=True, disable_signals=True)
        except OSError:
            if time.monotonic() > deadline:
                sys.exit("real_time: no ROS master")


def main():
    port = str(urllib.parse.urlparse(os.environ["ROS_MASTER_URI"]).port)
    launch = subprocess.Popen(
        ["roslaunch", "--no-summary", "-p", port, "smore", "retrieval.launch",
         f"scenario:={sys.argv[1]}", "rviz:=false", "real_time_factor:=1.0"],
    )  # fmt: skip
    wait_for_master()
    stream = Stream()
    rospy.Subscriber("wrench", WrenchStamped, stream.add, queue_size=1000, tcp_nodelay=True)
    begin = time.monotonic()
    launch.wait()
    wall = time.monotonic() - begin
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    stream.report()
    print(f"processor time: {(used.ru_utime + used.ru_stime) / wall:.2f} cores of {os.cpu_count()}")


if __name__ == "__main__":
    main()
