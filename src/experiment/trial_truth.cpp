// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/trial_truth.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "shape_json.h"
#include "smore/common/json_lines.h"
#include "smore/common/result.h"

namespace smore {
namespace {

Json shapesJson(const std::vector<Shape>& shapes) {
  Json list = Json::array();
  for (const Shape& shape : shapes) list.push_back(toJson(shape));
  return list;
}

std::vector<Shape> readShapes(const JsonFields& record, const std::string& key) {
  std::vector<Shape> shapes;
  for (const JsonFields& fields : record.list(key)) shapes.push_back(readShape(fields));
  return shapes;
}

std::vector<ContactPoint> readPoints(const JsonFields& record) {
  std::vector<ContactPoint> points;
  for (const JsonFields& point : record.list("points")) {
    points.push_back({point.vector("position"), point.vector("force"), point.text("body")});
  }
  return points;
}

void take(const JsonFields& record, TrialTruth* truth) {
  if (record.has("contact")) {
    const int id = record.integer("contact", 0, std::numeric_limits<int>::max());
    truth->contacts[id] = readPoints(record);
  } else {
    truth->object = readShapes(record, "object");
    truth->environment = readShapes(record, "environment");
  }
}

}  // namespace

Json solidsRecord(const Scenario& perturbed) {
  return {{"record", "truth"},
          {"object", shapesJson(perturbed.object)},
          {"environment", shapesJson(perturbed.environment)}};
}

Json contactTruthRecord(int contact_id, const std::vector<ContactPoint>& points) {
  Json list = Json::array();
  for (const ContactPoint& point : points) {
    list.push_back({{"position", toJson(point.position)},
                    {"force", toJson(point.force)},
                    {"body", point.body}});
  }
  return {{"record", "truth"}, {"contact", contact_id}, {"points", list}};
}

TrialTruth readTruth(const std::string& file) {
  TrialTruth truth;
  readJsonLines(file, [&](int line, const Json& record) {
    const JsonFields fields(record, file + ": line " + std::to_string(line));
    if (fields.raw("record") == "truth") take(fields, &truth);
  });
  if (truth.object.empty()) {
    throw InputError(file +
                     ": holds no true solids; only evidence of simulated trials can be "
                     "scored");
  }
  return truth;
}

}  // namespace smore
