// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/retrieval_summary.h"

#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace smore {
namespace {

nlohmann::json poseJson(const Pose& pose) {
  const Vec3 position = pose.translation();
  const Eigen::Quaterniond rotation(pose.linear());
  return {position.x(), position.y(), position.z(), rotation.x(),
          rotation.y(), rotation.z(), rotation.w()};
}

}  // namespace

smore_msgs::RetrieveFeedback toMessage(const RetrievalProgress& progress) {
  smore_msgs::RetrieveFeedback feedback;
  feedback.phase = phaseName(progress.phase);
  feedback.collisions = progress.collisions;
  feedback.plans = progress.plans;
  feedback.risk = progress.risk;
  return feedback;
}

smore_msgs::RetrieveResult toMessage(const RetrievalOutcome& outcome) {
  smore_msgs::RetrieveResult result;
  result.success = static_cast<unsigned char>(outcome.success);
  result.message = outcome.reason;
  result.collisions = outcome.collisions;
  result.plans = outcome.plans;
  result.path_length = outcome.path_length;
  return result;
}

std::string toText(const RetrievalSummary& summary) {
  const RetrievalOutcome& outcome = summary.outcome;
  std::ostringstream text;
  text << std::fixed << std::setprecision(2);
  const char* failure = summary.cancelled ? "CANCELLED: " : "FAILED: ";
  text << (outcome.success ? "SUCCESS: " : failure) << outcome.reason << "\n"
       << "  scenario     " << summary.scenario << ", method " << summary.method << "\n"
       << "  collisions   " << outcome.collisions << "\n"
       << "  plans        " << outcome.plans << ", " << outcome.planning_s << " s\n"
       << "  last way     " << outcome.path_length << " m\n"
       << "  time         " << summary.wall_s << " s";
  return text.str();
}

bool writeJson(const RetrievalSummary& summary, const std::string& file) {
  const RetrievalOutcome& outcome = summary.outcome;
  nlohmann::json path = nlohmann::json::array();
  for (const Pose& pose : outcome.path) path.push_back(poseJson(pose));
  const nlohmann::json json = {{"scenario", summary.scenario},
                               {"method", summary.method},
                               {"success", outcome.success},
                               {"cancelled", summary.cancelled},
                               {"reason", outcome.reason},
                               {"collisions", outcome.collisions},
                               {"plans", outcome.plans},
                               {"path_length", outcome.path_length},
                               {"planning_s", outcome.planning_s},
                               {"wall_s", summary.wall_s},
                               {"path", path}};
  std::ofstream stream(file);
  constexpr int kIndent = 2;
  stream << json.dump(kIndent) << "\n";
  stream.close();
  return !stream.fail();
}

}  // namespace smore
