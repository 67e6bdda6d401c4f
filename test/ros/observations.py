# SPDX-License-Identifier: BSD-3-Clause
"""Contact observations as a listener would publish them, generated."""

import rospy

from node_testing import PERIOD, pose, wait_until
from smore.msg import ContactObservation


class ObservationSource:
    def __init__(self, time=1.0):
        """The first stamp follows on `time` [s]."""
        self.time = time
        self.contacts = 0
        self.publisher = rospy.Publisher(
            "contact", ContactObservation, queue_size=100000, tcp_nodelay=True
        )

    def wait_for_listener(self):
        return wait_until(lambda: self.publisher.get_num_connections() > 0)

    def next(self, state, x=0.0, line=False):
        """The next observation, with the object at x [m]; its line is along -x through y = 0.2 m."""
        self.time += PERIOD
        message = ContactObservation()
        message.header.stamp = rospy.Time.from_sec(self.time)
        message.header.frame_id = "object"
        message.world_frame = "world"
        message.pose = pose(x)
        message.state = state
        message.contact_id = self.contacts
        message.has_line = line
        message.line.point.y = 0.2
        message.line.direction.x = -1.0
        message.line.force = 6.0
        return message

    def publish(self, message):
        self.publisher.publish(message)
        return message.header.stamp

    def stay(self, duration, x=0.0):
        """Free and still for `duration` [s]; returns the last stamp."""
        for _ in range(int(round(duration / PERIOD))):
            stamp = self.publish(self.next(ContactObservation.FREE, x))
        return stamp

    def touch(self, x=0.0):
        """A new contact with its line, then free again; returns the last stamp."""
        self.contacts += 1
        self.publish(self.next(ContactObservation.CONTACT, x))
        self.publish(self.next(ContactObservation.CONTACT, x, line=True))
        return self.publish(self.next(ContactObservation.FREE, x))
