// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/wrench_axes.h"

#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace smore {
namespace {

constexpr char kNames[] = "xyz";

// The unit vector of "x" or "-x".
std::optional<Vec3> axisNamed(std::string name) {
  double sign = 1.0;
  if (!name.empty() && name.front() == '-') {
    sign = -1.0;
    name.erase(0, 1);
  }
  const size_t axis = name.size() == 1 ? std::string(kNames).find(name) : std::string::npos;
  if (axis == std::string::npos) return std::nullopt;
  return Vec3(sign * Vec3::Unit(static_cast<Eigen::Index>(axis)));
}

// The turn whose rows are the named axes; none where a name is wrong or they are no right-handed
// frame.
std::optional<Eigen::Matrix3d> turnOf(const std::array<std::string, 3>& names) {
  Eigen::Matrix3d turn;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const std::optional<Vec3> axis = axisNamed(names.at(static_cast<size_t>(row)));
    if (!axis) return std::nullopt;
    turn.row(row) = axis->transpose();
  }
  if (std::abs(turn.determinant() - 1.0) > 0.5) return std::nullopt;
  return turn;
}

std::optional<Eigen::Matrix3d> turnNamed(const std::string& text) {
  std::istringstream words(text);
  std::array<std::string, 3> names;
  std::string more;
  words >> names[0] >> names[1] >> names[2] >> more;
  return more.empty() ? turnOf(names) : std::nullopt;
}

}  // namespace

Wrench inFrame(const WrenchAxes& axes, const Wrench& of_driver) {
  return {axes.sign * (axes.turn * of_driver.force), axes.sign * (axes.turn * of_driver.torque)};
}

WrenchAxes compose(const WrenchAxes& second, const WrenchAxes& first) {
  return {second.turn * first.turn, second.sign * first.sign};
}

std::vector<WrenchAxes> allWrenchAxes() {
  std::vector<WrenchAxes> all;
  const std::vector<std::string> names{"x", "y", "z", "-x", "-y", "-z"};
  for (const double sign : {1.0, -1.0}) {
    for (const std::string& x : names) {
      for (const std::string& y : names) {
        for (const std::string& z : names) {
          if (const auto turn = turnOf({x, y, z})) all.push_back({*turn, sign});
        }
      }
    }
  }
  return all;
}

std::string toText(const WrenchAxes& axes) {
  std::ostringstream text;
  text << "wrench_sign: " << axes.sign << ", wrench_axes:";
  for (int row = 0; row < 3; ++row) {
    Eigen::Index axis = 0;
    axes.turn.row(row).cwiseAbs().maxCoeff(&axis);
    text << (axes.turn(row, axis) < 0.0 ? " -" : " ") << kNames[axis];
  }
  return text.str();
}

WrenchAxes readWrenchAxes(ParameterReader* reader) {
  WrenchAxes axes;
  if (reader->has("wrench_sign")) reader->number("wrench_sign", &axes.sign, {-1.0, 1.0});
  if (std::abs(axes.sign) != 1.0) reader->error("wrench_sign", "is neither 1 nor -1; give one");
  std::string names = "x y z";
  if (reader->has("wrench_axes")) reader->text("wrench_axes", &names);
  const std::optional<Eigen::Matrix3d> turn = turnNamed(names);
  if (!turn) {
    reader->error("wrench_axes", "'" + names +
                                     "' is no right-handed frame of x, y and z; give three of them "
                                     "with their signs, as \"y -x z\"");
  }
  axes.turn = turn.value_or(axes.turn);
  return axes;
}

}  // namespace smore
