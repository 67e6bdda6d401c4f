# SPDX-License-Identifier: BSD-3-Clause
"""A generated robot for tests of the guard."""

import threading

import rospy
from geometry_msgs.msg import WrenchStamped
from sensor_msgs.msg import JointState
from std_msgs.msg import Empty
from trajectory_msgs.msg import JointTrajectory

from smore.msg import ContactObservation

JOINTS = [
    "shoulder_pan_joint",
    "shoulder_lift_joint",
    "elbow_joint",
    "wrist_1_joint",
    "wrist_2_joint",
    "wrist_3_joint",
]
PERIOD = 0.01  # of both streams [s]


class Driver:
    """A robot at rest that goes where it is told at once, until it is told to be silent or to feel
    something; with the listener that goes with it."""

    def __init__(self):
        self.force = 0.0  # [N]
        self.contact_id = 0
        self.felt = 0  # wrenches that the guard was there to receive
        self.wrenches = self.joints = self.contacts = self.attended = True
        self.noise = 0.01  # turns its sign with each wrench [N]
        self.age = 0.0  # of all stamps [s]
        self.position = 0.0
        self.horizon = None  # the last piece of a motion that it was told
        self._wrench = rospy.Publisher("wrench", WrenchStamped, queue_size=1, tcp_nodelay=True)
        self._joints = rospy.Publisher("joint_states", JointState, queue_size=1, tcp_nodelay=True)
        self._contact = rospy.Publisher("contact", ContactObservation, queue_size=1)
        self._life = rospy.Publisher("command_attended", Empty, queue_size=1)
        self._command = rospy.Subscriber("guarded_command", JointTrajectory, self._follow)
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _follow(self, message):
        if message.points:
            self.position = message.points[0].positions[0]
        if len(message.points) > 1:
            self.horizon = message

    def _run(self):
        while not self._end.wait(PERIOD):
            now = rospy.Time.now() - rospy.Duration.from_sec(self.age)
            if self.wrenches:
                wrench = WrenchStamped()
                wrench.header.stamp = now
                wrench.wrench.force.z = self.force
                wrench.wrench.force.x = self.noise
                self.noise = -self.noise
                self._wrench.publish(wrench)
                self.felt += self._wrench.get_num_connections() > 0
            if self.joints:
                joints = JointState(name=JOINTS, position=[self.position] * 6, velocity=[0.0] * 6)
                joints.header.stamp = now
                self._joints.publish(joints)
            if self.contacts:
                contact = ContactObservation(contact_id=self.contact_id)
                contact.header.stamp = now
                touches = self.contact_id > 0
                contact.state = ContactObservation.CONTACT if touches else ContactObservation.FREE
                self._contact.publish(contact)
            if self.attended:
                self._life.publish(Empty())

    def stop_listening(self):
        self._command.unregister()

    def close(self):
        self._end.set()
        self._thread.join()
        self.stop_listening()
