# SPDX-License-Identifier: BSD-3-Clause
"""Helpers for tests of the nodes: conditions with deadlines, recorded topics, generated wrenches."""

import math
import threading
import time

import rospy
from geometry_msgs.msg import Pose, PoseStamped, Quaternion, TransformStamped, WrenchStamped
from rosgraph_msgs.msg import Log
from tf2_msgs.msg import TFMessage

DEADLINE = 30.0  # [s]; only failing tests wait so long
PERIOD = 0.002  # of the sensor [s]


def start_node(name):
    """Joins the master under `name`."""
    rospy.init_node(name, anonymous=True, disable_signals=True)


class Recorder:
    """Everything that comes on a topic."""

    def __init__(self, topic, kind):
        self._arrived = threading.Condition()
        self._messages = []
        self._subscriber = rospy.Subscriber(topic, kind, self._add, tcp_nodelay=True)

    def _add(self, message):
        with self._arrived:
            self._messages.append(message)
            self._arrived.notify_all()

    def messages(self):
        with self._arrived:
            return list(self._messages)

    def clear(self):
        with self._arrived:
            self._messages.clear()

    def wait_for(self, condition, deadline=DEADLINE):
        """The first message for which `condition` holds; None at the deadline."""
        end = time.monotonic() + deadline
        seen = 0
        with self._arrived:
            while True:
                for message in self._messages[seen:]:
                    if condition(message):
                        return message
                seen = len(self._messages)
                if not self._arrived.wait(end - time.monotonic()):
                    return None

    def wait_for_publisher(self, deadline=DEADLINE):
        return wait_until(lambda: self._subscriber.get_num_connections() > 0, deadline)

    def close(self):
        self._subscriber.unregister()


def wait_until(condition, deadline=DEADLINE):
    """Whether `condition` becomes true in time; for what has no event to wait for."""
    end = time.monotonic() + deadline
    pause = threading.Event()
    while not condition():
        if time.monotonic() > end:
            return False
        pause.wait(0.01)
    return True


def pose(x=0.0, y=0.0, yaw=0.0):
    message = Pose()
    message.position.x = x
    message.position.y = y
    message.orientation = Quaternion(0.0, 0.0, math.sin(yaw / 2.0), math.cos(yaw / 2.0))
    return message


def stamped(message, frame="world"):
    result = PoseStamped()
    result.header.frame_id = frame
    result.pose = message
    return result


class Warnings:
    """What a node warns of."""

    def __init__(self, node):
        self._log = Recorder("/rosout", Log)
        self._node = node

    def texts(self, part):
        """The warnings so far in which `part` occurs."""
        return [
            message.msg
            for message in self._log.messages()
            if message.name == self._node and message.level == Log.WARN and part in message.msg
        ]

    def wait_for(self, part):
        return self._log.wait_for(
            lambda message: message.name == self._node and part in message.msg
        )

    def wait_for_publisher(self):
        return self._log.wait_for_publisher()


class WristSource:
    """A generated sensor: wrenches at 500 Hz of its own time, with the poses that belong to them."""

    def __init__(self):
        self.time = 1.0
        self.wrench = rospy.Publisher("wrench", WrenchStamped, queue_size=10000, tcp_nodelay=True)
        self.tf = rospy.Publisher("/tf", TFMessage, queue_size=10000, tcp_nodelay=True)

    def wait_for_listener(self, listeners=1):
        return wait_until(
            lambda: min(p.get_num_connections() for p in (self.wrench, self.tf)) >= listeners
        )

    def send(
        self,
        force=(0, 0, 0),
        torque=(0, 0, 0),
        at=None,
        frame="object",
        with_pose=True,
        stamp=None,
    ):
        """One sample, a period after the last one or with a stamp of its own; returns its stamp."""
        if stamp is None:
            self.time += PERIOD
            stamp = rospy.Time.from_sec(self.time)
        if with_pose:
            self.tf.publish(TFMessage([transform("world", "object", at or pose(), stamp)]))
        message = WrenchStamped()
        message.header.stamp = stamp
        message.header.frame_id = frame
        message.wrench.force.x, message.wrench.force.y, message.wrench.force.z = force
        message.wrench.torque.x, message.wrench.torque.y, message.wrench.torque.z = torque
        self.wrench.publish(message)
        return stamp

    def send_for(self, duration, **sample):
        for _ in range(int(round(duration / PERIOD))):
            stamp = self.send(**sample)
        return stamp


def transform(parent, child, at, stamp):
    message = TransformStamped()
    message.header.stamp = stamp
    message.header.frame_id = parent
    message.child_frame_id = child
    message.transform.translation.x = at.position.x
    message.transform.translation.y = at.position.y
    message.transform.translation.z = at.position.z
    message.transform.rotation = at.orientation
    return message
