// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "smore/ros/map_keeper.h"

namespace smore {

constexpr double kLongEnough = 20.0;  // [s]; a wait that fails takes this long
const EvidenceSpacing kSpacing{0.003, 0.01, std::nullopt};

inline EvidenceSource source(MethodKind method) {
  EvidenceSource source;
  source.method = method;
  source.task.goal = makePose({-0.3, 0.0, 0.0});
  source.task.workspace = {{-0.5, -0.5, -0.01}, {0.5, 0.5, 0.01}};
  return source;
}

inline MapKeeper::MakeMaps emptyMaps(MethodKind method) {
  return [method](const Priors& priors) {
    return makeTwinMap(method, source(method).task, 1, {}, priors);
  };
}

// Motions that end at contacts, numbered from 1 on as a listener does that has just been started.
inline std::vector<ContactObservation> touches(std::uint64_t seed, double begin, int count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  std::vector<ContactObservation> observations;
  ContactObservation now;
  now.time = begin;
  for (int id = 0; id <= count; ++id) {
    now.line.reset();
    if (id > 0) {
      now.state = ContactState::kContact;
      now.contact_id = id;
      const double heading = 15.0 * uniform(random);
      LineOfAction line;
      line.direction = {std::cos(heading), std::sin(heading), 0.0};
      line.point = uniform(random) * Vec3(-line.direction.y(), line.direction.x(), 0.0);
      line.force = 6.0;
      now.line = line;
      observations.push_back(now);
      now.line.reset();
    }
    now.state = ContactState::kFree;
    const Vec3 from = now.T_world_object.translation();
    const Vec3 to(uniform(random), uniform(random), 0.0);
    for (int step = 1; step <= 10; ++step) {
      now.time += 0.1;
      now.T_world_object = makePose(from + 0.1 * step * (to - from));
      observations.push_back(now);
    }
  }
  return observations;
}

inline void feed(MapKeeper* keeper, const std::vector<ContactObservation>& observations) {
  for (const ContactObservation& observation : observations) keeper->push(observation);
  ASSERT_TRUE(keeper->waitFor(observations.back().time, kLongEnough));
}

inline void expectSame(const VoxelGrid& a, const VoxelGrid& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.voxels()[i].key, b.voxels()[i].key);
    EXPECT_EQ(a.voxels()[i].probability, b.voxels()[i].probability);
  }
}

inline void expectSameState(const MapKeeper& a, const MapKeeper& b) {
  a.access([&](const MapState& one) {
    b.access([&](const MapState& other) {
      expectSame(one.maps->world(), other.maps->world());
      expectSame(one.maps->object(), other.maps->object());
      EXPECT_GT(one.maps->world().size(), 0U);
      EXPECT_EQ(one.log.size(), other.log.size());
      EXPECT_EQ(one.lines.size(), other.lines.size());
      EXPECT_EQ(changesOf(one), changesOf(other));
    });
  });
}

}  // namespace smore
