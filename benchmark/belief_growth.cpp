// SPDX-License-Identifier: BSD-3-Clause
// How the cost of the joint belief grows with the number of contacts.
//
//   belief_growth SCENARIO.yaml CONTACTS [MOST_CONTACTS]
//
// Moves the scenario's object (planar: in the world's x-y plane) along straight motions until it
// touches, takes each touch as a contact, has the worlds made after each as a retrieval does, and
// prints one row of CSV at each of some numbers of contacts: the processor time that a free pose
// takes, that from a contact to its worlds and maps, the time that passes in the latter on all
// cores, that in which what touches are looked up in is made, as the first plan does, and the
// memory of the process.
#include <sys/resource.h>

#include <chrono>
#include <ctime>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "smore/mapping/joint_belief.h"
#include "smore/scenario/scenario.h"

namespace smore {
namespace {

constexpr double kStep = 0.01;         // of the motions [m]
constexpr double kSurfaceStep = 0.02;  // between the points that stand for the object's surface [m]
constexpr int kMotionsPerContact = 1000;

// What passes between two readings, in seconds.
struct Times {
  double processor;  ///< of this process on all cores: other load on the machine does not count
  double wall;
};

Times now() {
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now().time_since_epoch();
  return {static_cast<double>(std::clock()) / CLOCKS_PER_SEC, wall.count()};
}

Times since(const Times& begin) {
  const Times end = now();
  return {end.processor - begin.processor, end.wall - begin.wall};
}

// Points on the surface of the object, in its frame.
std::vector<Vec3> surfaceOf(const std::vector<Shape>& shapes) {
  const Bounds bounds = boundsOf(shapes);
  std::vector<Vec3> points;
  for (double x = bounds.min.x(); x <= bounds.max.x(); x += kSurfaceStep) {
    for (double y = bounds.min.y(); y <= bounds.max.y(); y += kSurfaceStep) {
      for (double z = bounds.min.z(); z <= bounds.max.z(); z += kSurfaceStep) {
        const Vec3 point(x, y, z);
        const double distance = signedDistance(shapes, point);
        if (distance <= 0.0 && distance > -kSurfaceStep) points.push_back(point);
      }
    }
  }
  return points;
}

// Outward normal of the environment near a point, by differences.
Vec3 normalAt(const std::vector<Shape>& shapes, const Vec3& point) {
  constexpr double kStepOfDifference = 1e-4;
  Vec3 normal;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 step = kStepOfDifference * Vec3::Unit(axis);
    normal[axis] = signedDistance(shapes, point + step) - signedDistance(shapes, point - step);
  }
  return normal.normalized();
}

class RandomTouch {
 public:
  explicit RandomTouch(const Scenario& scenario)
      : scenario_(scenario), surface_(surfaceOf(scenario.object)) {}

  // Free poses of one motion, and the contact that ended it; no contact where it met nothing.
  std::vector<ContactObservation> next() {
    std::vector<ContactObservation> observations;
    Pose pose = randomPose();
    const Vec3 direction = (randomPose().translation() - pose.translation()).normalized();
    while (scenario_.motionSpace().workspace.contains(pose.translation())) {
      observations.push_back(observe(pose));
      if (observations.back().state == ContactState::kContact) return observations;
      pose.translation() += kStep * direction;
    }
    return observations;
  }

 private:
  ContactObservation observe(const Pose& pose) const {
    ContactObservation observation;
    observation.T_world_object = pose;
    observation.state = ContactState::kFree;
    for (const Vec3& point : surface_) {
      if (signedDistance(scenario_.environment, pose * point) > 0.0) continue;
      observation.state = ContactState::kContact;
      LineOfAction line;
      line.direction = pose.linear().transpose() * normalAt(scenario_.environment, pose * point);
      line.point = point - point.dot(line.direction) * line.direction;
      line.force = scenario_.contact_force;
      observation.line = line;
      break;
    }
    return observation;
  }

  Pose randomPose() {
    const Bounds& workspace = scenario_.workspace;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const Vec3 share(uniform(random_), uniform(random_), uniform(random_));
    Pose pose = Pose::Identity();
    pose.translation() = workspace.min + share.cwiseProduct(Vec3(workspace.max - workspace.min));
    if (scenario_.motion == Motion::kPlanar) {
      pose.translation().z() = 0.0;
      const double yaw = 2.0 * M_PI * uniform(random_);
      pose.linear() = Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix();
      return pose;
    }
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond turn(normal(random_), normal(random_), normal(random_),
                                  normal(random_));
    pose.linear() = turn.normalized().toRotationMatrix();
    return pose;
  }

  const Scenario& scenario_;
  std::vector<Vec3> surface_;
  std::mt19937 random_{1};
};

double memoryInMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

bool isReported(int contacts) { return contacts <= 100 ? contacts % 20 == 0 : contacts % 100 == 0; }

struct Cost {
  double free_pose_s = 0.0;   ///< mean over the free poses since the last contact
  Times contact_s{0.0, 0.0};  ///< to take the contact in, merging included
};

// Feeds motions until one ends in a contact.
Cost feedUntilContact(RandomTouch* touch, JointBelief* belief) {
  double free_s = 0.0;
  int free = 0;
  for (int i = 0; i < kMotionsPerContact; ++i) {
    const std::vector<ContactObservation> observations = touch->next();
    // Motions that begin in matter are none.
    if (observations.empty() || observations.front().state == ContactState::kContact) continue;
    for (const ContactObservation& observation : observations) {
      const Times begin = now();
      belief->observe(observation);
      const Times taken = since(begin);
      if (observation.state == ContactState::kContact) return {free_s / free, taken};
      free_s += taken.processor;
      ++free;
    }
  }
  throw std::runtime_error("no contact in " + std::to_string(kMotionsPerContact) + " motions");
}

void run(const Scenario& scenario, int contacts, int most_contacts) {
  JointBeliefParameters parameters;
  parameters.voxel_size = scenario.voxel_size;
  if (scenario.motion == Motion::kPlanar) parameters.T_world_plane = Pose::Identity();
  parameters.most_contacts = most_contacts;
  JointBelief belief(parameters);
  RandomTouch touch(scenario);
  std::cout << "contacts,free_poses,free_pose_s,update_s,update_wall_s,touching_wall_s,memory_mb"
            << std::endl;
  while (static_cast<int>(belief.contactCount()) < contacts) {
    const Cost cost = feedUntilContact(&touch, &belief);
    const int count = static_cast<int>(belief.contactCount());
    if (!isReported(count)) {
      belief.worlds();
      continue;
    }
    const Times begin = now();
    belief.world();
    const Times update = since(begin);
    const Times ready = now();
    belief.worlds()->sampled.prepareTouching();
    const Times touching = since(ready);
    std::cout << count << ',' << belief.worlds()->free.count() << ',' << cost.free_pose_s << ','
              << cost.contact_s.processor + update.processor << ','
              << cost.contact_s.wall + update.wall << ',' << touching.wall << ','
              << memoryInMegabytes() << std::endl;
  }
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::cerr << "usage: belief_growth SCENARIO.yaml CONTACTS [MOST_CONTACTS]" << std::endl;
    return 2;
  }
  try {
    const smore::JointBeliefParameters defaults;
    smore::run(smore::loadScenario(argv[1]), std::stoi(argv[2]),
               argc > 3 ? std::stoi(argv[3]) : defaults.most_contacts);
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}
