// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/parameter_source.h"

#include <ros/ros.h>

#include <cstdio>
#include <sstream>

#include "smore/common/result.h"
#include "smore/scenario/scenario_files.h"

namespace smore {
namespace {

YAML::Node arrayToYaml(const XmlRpc::XmlRpcValue& value) {
  YAML::Node list(YAML::NodeType::Sequence);
  const int size = value.size();  // arrays have no iterators
  for (int i = 0; i < size; ++i) list.push_back(toYaml(value[i]));
  return list;
}

YAML::Node structToYaml(XmlRpc::XmlRpcValue* value) {
  YAML::Node mapping(YAML::NodeType::Map);
  for (auto& entry : *value) mapping[entry.first] = toYaml(entry.second);
  return mapping;
}

void logLines(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) ROS_FATAL_STREAM(line);
}

}  // namespace

YAML::Node toYaml(const XmlRpc::XmlRpcValue& value) {
  XmlRpc::XmlRpcValue copy = value;  // its conversions are not const
  switch (copy.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(copy));
    case XmlRpc::XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<int>(copy));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return YAML::Node(static_cast<double>(copy));
    case XmlRpc::XmlRpcValue::TypeString:
      return YAML::Node(static_cast<std::string>(copy));
    case XmlRpc::XmlRpcValue::TypeArray:
      return arrayToYaml(copy);
    case XmlRpc::XmlRpcValue::TypeStruct:
      return structToYaml(&copy);
    default:
      return YAML::Node();
  }
}

YAML::Node privateParameters() {
  XmlRpc::XmlRpcValue value;
  if (!ros::param::get(ros::this_node::getName(), value)) {
    return YAML::Node(YAML::NodeType::Map);
  }
  return toYaml(value);
}

std::optional<Scenario> readScenarioParameter(ParameterReader* reader) {
  std::string directory;
  if (reader->has("scenario_directory")) reader->text("scenario_directory", &directory);
  if (!reader->has("scenario")) return std::nullopt;
  std::string name;
  reader->text("scenario", &name);
  try {
    return loadScenario(findScenario(name, directory));
  } catch (const InputError& error) {
    reader->error("scenario", error.what());
    return std::nullopt;
  }
}

void requireScenario(ParameterReader* reader) {
  if (!reader->has("scenario")) {
    reader->error("scenario", "missing; give the name of a scenario or the path of its file");
  }
}

MethodKind readMethod(ParameterReader* reader) {
  const std::vector<MethodKind> kinds = {MethodKind::kPaper, MethodKind::kCspace,
                                         MethodKind::kSmore};
  std::vector<std::string> choices;
  choices.reserve(kinds.size());
  for (const MethodKind kind : kinds) choices.push_back(methodName(kind));
  int index = 0;
  reader->choice("method", choices, &index);
  return kinds[index];
}

MethodParameters readMethodChanges(ParameterReader* reader, MethodKind method,
                                   const MethodParameters& defaults) {
  if (!reader->has("parameters")) return defaults;
  std::string file;
  reader->text("parameters", &file);
  try {
    checkTakesParameters(method);
    return loadMethodParameters(file, defaults);
  } catch (const InputError& error) {
    reader->error("parameters", error.what());
    return defaults;
  }
}

FrameNames readFrameNames(ParameterReader* reader) {
  FrameNames frames;
  reader->text("world_frame", &frames.world);
  reader->text("object_frame", &frames.object);
  return frames;
}

void imposeScenarioValue(YAML::Node mapping, const std::string& group, const std::string& key,
                         double value, ParameterReader* reader) {
  YAML::Node values = mapping[group];
  double given = value;
  const YAML::Node present = values[key];
  if (present.IsDefined() && YAML::convert<double>::decode(present, given) && given != value) {
    std::ostringstream problem;
    problem << "is " << given << " here and " << value
            << " in the scenario; remove it here, the scenario decides";
    reader->error(group + "." + key, problem.str());
  }
  values[key] = value;
}

int runNode(int argc, char** argv, const std::string& name, const std::function<void()>& run) {
  // Lines appear as they are logged, to a pipe or file too.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  ros::init(argc, argv, name);
  ros::start();  // else logging would end with the last node handle, before the errors below
  try {
    run();
    ros::shutdown();
    return 0;
  } catch (const InputError& error) {
    logLines(error.what());
    return 2;
  } catch (const std::runtime_error& error) {
    logLines(error.what());
    return 1;
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM("stopped by an internal error: " << error.what());
    return 1;
  }
}

}  // namespace smore
