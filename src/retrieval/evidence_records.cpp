// SPDX-License-Identifier: BSD-3-Clause
#include "evidence_records.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "prior_record.h"
#include "smore/common/version.h"
#include "task_record.h"

namespace smore {
namespace {

const std::vector<std::string> kStates = {"free", "unsure", "contact"};
const std::vector<std::string> kEnds = {"reached", "contact", "unreachable", "fault", "stopped"};

constexpr Range kProbability{0.0, 1.0};
constexpr Range kTimes{0.0, std::numeric_limits<std::uint32_t>::max()};  // what ROS can tell [s]
constexpr Range kNotNegative{0.0, std::numeric_limits<double>::max()};
constexpr double kUnitTolerance = 1e-6;

Json lineJson(const LineOfAction& line) {
  return {{"point", toJson(line.point)},
          {"direction", toJson(line.direction)},
          {"force", line.force},
          {"pitch", line.pitch},
          {"direction_stddev", line.direction_stddev},
          {"offset_stddev", line.offset_stddev}};
}

LineOfAction readLine(const JsonFields& fields) {
  LineOfAction line;
  line.point = fields.vector("point");
  line.direction = fields.vector("direction");
  if (std::abs(line.direction.norm() - 1.0) > kUnitTolerance) {
    fields.fail("direction", "expected a unit vector");
  }
  line.force = fields.number("force", kNotNegative);
  line.pitch = fields.number("pitch");
  line.direction_stddev = fields.number("direction_stddev", kNotNegative);
  line.offset_stddev = fields.number("offset_stddev", kNotNegative);
  return line;
}

Json headerRecord() {
  return {{"format", kEvidenceFormat},
          {"version", kEvidenceVersion},
          {"program", std::string("smore ") + programVersion()}};
}

Json methodRecord(const EvidenceSource& source) {
  Json record{{"record", "method"}, {"method", methodName(source.method)}, {"seed", source.seed}};
  if (takesParameters(source.method)) {
    record["parameters"] = toJson(source.method, source.parameters);
  }
  return record;
}

}  // namespace

std::vector<Json> sourceRecords(const EvidenceSource& source) {
  std::vector<Json> records = {headerRecord(), taskRecord(source.task), methodRecord(source)};
  for (const Prior& prior : source.priors.object) {
    records.push_back(priorRecord(MapSide::kObject, prior));
  }
  for (const Prior& prior : source.priors.world) {
    records.push_back(priorRecord(MapSide::kWorld, prior));
  }
  return records;
}

Json observationRecord(const ContactObservation& observation) {
  Json record{{"record", "observation"},
              {"time", observation.time},
              {"state", kStates[static_cast<std::size_t>(observation.state)]},
              {"contact", observation.contact_id},
              {"pose", toJson(observation.T_world_object)}};
  if (observation.line) record["line"] = lineJson(*observation.line);
  return record;
}

ContactObservation readObservation(const JsonFields& record) {
  ContactObservation observation;
  observation.time = record.number("time", kTimes);
  observation.state = static_cast<ContactState>(record.choice("state", kStates));
  observation.contact_id = record.integer("contact", 0, std::numeric_limits<int>::max());
  observation.T_world_object = record.pose("pose");
  if (record.has("line")) observation.line = readLine(record.object("line"));
  return observation;
}

Json motionRecord(const Path& path, const std::optional<double>& risk) {
  Json poses = Json::array();
  for (const Pose& pose : path) poses.push_back(toJson(pose));
  Json record{{"record", "motion"}, {"path", poses}};
  if (risk) record["risk"] = *risk;
  return record;
}

RecordedMotion readMotion(const JsonFields& record) {
  RecordedMotion motion;
  motion.path = record.path("path");
  if (record.has("risk")) motion.risk = record.number("risk", kProbability);
  return motion;
}

Json motionEndRecord(const MotionResult& result, const Pose& T_world_object) {
  Json record{{"record", "motion_end"},
              {"end", kEnds[static_cast<std::size_t>(result.end)]},
              {"pose", toJson(T_world_object)},
              {"length", result.length}};
  if (!result.reason.empty()) record["reason"] = result.reason;
  return record;
}

void readMotionEnd(const JsonFields& record, RecordedMotion* motion) {
  motion->end = static_cast<MotionEnd>(record.choice("end", kEnds));
  motion->T_world_end = record.pose("pose");
  motion->length = record.number("length", kNotNegative);
}

Json outcomeRecord(const RecordedOutcome& outcome) {
  return {{"record", "outcome"},
          {"success", outcome.success},
          {"reason", outcome.reason},
          {"collisions", outcome.collisions}};
}

RecordedOutcome readOutcome(const JsonFields& record) {
  return {record.boolean("success"), record.text("reason"),
          record.integer("collisions", 0, std::numeric_limits<int>::max())};
}

}  // namespace smore
