// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/written_touches.h"

#include <utility>

#include "smore/common/parameters.h"
#include "smore/common/yaml_file.h"

namespace smore {
namespace {

Pose readPose(ParameterReader* reader, const MotionSpace& space) {
  Vec3 position = Vec3::Zero();
  Vec3 rpy = Vec3::Zero();
  reader->vector("position", &position);
  if (reader->has("rpy")) reader->angles("rpy", &rpy);
  Pose pose = makePose(position, rpy);
  const std::string problem = space.whyOutside(pose);
  if (!problem.empty()) reader->error("position", problem);
  reader->finishNested();
  return pose;
}

}  // namespace

WrittenTouches::WrittenTouches(std::vector<Path> motions) : motions_(std::move(motions)) {}

Result<Path> WrittenTouches::nextTouch(const Pose& from) {
  if (next_ == motions_.size()) return Path{};
  Path path{from};
  path.insert(path.end(), motions_[next_].begin(), motions_[next_].end());
  ++next_;
  return path;
}

std::vector<Path> loadMotions(const std::string& file, const MotionSpace& space) {
  ParameterReader reader(loadYaml(file), file);
  std::vector<Path> motions;
  for (ParameterReader& entry : reader.list("motions")) {
    Path& motion = motions.emplace_back();
    for (ParameterReader& pose : entry.list("poses")) motion.push_back(readPose(&pose, space));
    entry.finishNested();
  }
  reader.finish();
  return motions;
}

}  // namespace smore
