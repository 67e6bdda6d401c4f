// SPDX-License-Identifier: BSD-3-Clause
// The module smore_simulator of Python: a trial that is moved by actions. Its arrays are copies.
#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <utility>

#include "smore/common/result.h"
#include "smore/experiment/stepped_trial.h"
#include "smore/scenario/scenario_files.h"

namespace smore {
namespace {

namespace py = pybind11;

using Vector6 = Eigen::Matrix<double, 6, 1>;
/// Centres of voxels, one a row [m], and their probabilities.
using MapArrays = std::pair<Eigen::MatrixX3d, Eigen::VectorXd>;

std::unique_ptr<SteppedTrial> makeTrial(const std::string& scenario, std::uint64_t seed,
                                        const std::optional<std::string>& maps) {
  std::optional<MethodKind> kind;
  if (maps) kind = methodKind(*maps);
  const std::string file = findScenario(scenario, shippedScenarioDirectory());
  return std::make_unique<SteppedTrial>(loadScenario(file), seed, kind);
}

MapArrays arraysOf(const VoxelGrid& grid) {
  const auto count = static_cast<Eigen::Index>(grid.size());
  MapArrays arrays{Eigen::MatrixX3d(count, 3), Eigen::VectorXd(count)};
  Eigen::Index row = 0;
  for (const VoxelGrid::Voxel& voxel : grid.voxels()) {
    arrays.first.row(row) = voxelCenter(voxel.key, grid.voxelSize());
    arrays.second[row++] = voxel.probability;
  }
  return arrays;
}

Vector6 vectorOf(const Wrench& wrench) {
  Vector6 vector;
  vector << wrench.force, wrench.torque;
  return vector;
}

void defineOutcome(py::module_* module) {
  py::class_<StepOutcome>(*module, "StepOutcome", "What one action led to.")
      .def_property_readonly(
          "contact", [](const StepOutcome& outcome) { return outcome.end == MotionEnd::kContact; },
          "Whether a contact ended the motion.")
      .def_property_readonly(
          "refused",
          [](const StepOutcome& outcome) { return outcome.end == MotionEnd::kUnreachable; },
          "Whether the robot cannot move there, and did not move.")
      .def_readonly("reason", &StepOutcome::reason,
                    "Why the robot refused the motion or broke it off; empty where it did not.")
      .def_property_readonly(
          "pose", [](const StepOutcome& outcome) { return outcome.T_world_object.matrix(); },
          "T_world_object (4 x 4) where the motion ended, before the object went back.")
      .def_property_readonly(
          "wrench", [](const StepOutcome& outcome) { return vectorOf(outcome.wrench); },
          "Force [N] and torque [N m] on the object there, in the object frame.")
      .def_readonly("at_goal", &StepOutcome::at_goal,
                    "Whether the motion ended at the goal, without a contact.");
}

void defineTrial(py::module_* module) {
  py::class_<SteppedTrial>(*module, "SteppedTrial",
                           "One trial of smore_experiment, moved by actions instead of by plans.")
      .def(py::init(&makeTrial), py::arg("scenario"), py::arg("seed"),
           py::arg("maps") = std::nullopt,
           "scenario: a name in config/scenarios or a file; maps: 'paper', 'smore' or None.")
      .def_property_readonly("dimensions", &SteppedTrial::dimensions, "Numbers of an action.")
      .def("step", &SteppedTrial::step, py::arg("action"),
           "Moves by an action [m, rad], clipped to the largest magnitudes.")
      .def("restart", &SteppedTrial::restart, "Back to the start.")
      .def("difference", &SteppedTrial::difference, "From the object's pose to the goal [m, rad].")
      .def_property_readonly(
          "pose", [](const SteppedTrial& trial) { return trial.pose().matrix(); },
          "T_world_object (4 x 4) now.")
      .def_property_readonly(
          "axes", [](const SteppedTrial& trial) { return trial.T_world_axes().matrix(); },
          "The axes of actions and differences in the world (4 x 4).")
      .def_property_readonly(
          "goal", [](const SteppedTrial& trial) { return trial.scene().goal.matrix(); },
          "T_world_object at the goal (4 x 4).")
      .def_property_readonly("collisions", &SteppedTrial::collisions, "Contacts so far.")
      .def_property_readonly("time", &SteppedTrial::time, "Simulated time [s].")
      .def_property_readonly(
          "voxel_size", [](const SteppedTrial& trial) { return trial.scene().voxel_size; }, "[m]")
      .def_property_readonly(
          "workspace",
          [](const SteppedTrial& trial) {
            return std::make_pair(trial.scene().workspace.min, trial.scene().workspace.max);
          },
          "Lowest and highest corner of where the object frame's origin may be [m].")
      .def_property_readonly(
          "reach", [](const SteppedTrial& trial) { return reachOf(trial.scene().object); },
          "Distance of the object's farthest point from its origin, at most [m].")
      .def(
          "world_map", [](const SteppedTrial& trial) { return arraysOf(trial.maps().world()); },
          "Centres (n x 3) [m] and probabilities (n) of the world's voxels that are known.")
      .def(
          "object_map", [](const SteppedTrial& trial) { return arraysOf(trial.maps().object()); },
          "The same of the object, in the object frame.");
}

}  // namespace
}  // namespace smore

PYBIND11_MODULE(smore_simulator, module) {
  module.doc() = "The simulator of smore_experiment for Python.";
  module.attr("LARGEST_SHIFT") = smore::kLargestShift;
  module.attr("LARGEST_TURN") = smore::kLargestTurn;
  pybind11::register_exception<smore::InputError>(module, "InputError", PyExc_ValueError);
  smore::defineOutcome(&module);
  smore::defineTrial(&module);
}
