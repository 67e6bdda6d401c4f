// SPDX-License-Identifier: BSD-3-Clause
// Makes a robot of an installed scenario, and says where the scenarios are.
#include <every_header.h>

#include <iostream>

int main() {
  const std::string scenarios = smore::shippedScenarioDirectory();
  const smore::Scenario scenario = smore::loadScenario(smore::findScenario("one_peg", scenarios));
  const auto robot = smore::makeSimulatedRobot(scenario, 1);
  std::cout << scenarios << std::endl;
  return robot->moving() ? 1 : 0;
}
