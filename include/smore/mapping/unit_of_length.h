// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "smore/common/geometry.h"

namespace smore {

/// Units of length that are told apart.
constexpr int kUnits = 20;

/// The unit of length of a scene [m]: how far from the hand what it holds is touched, on each axis
/// across the lines of action. All that the belief and the search assume of the size of matter is a
/// multiple of it, or of a smaller one where matter is thin against what is held: the scene of a
/// pen in a drawer and that of a chair in a room differ in nothing else. `index` is from 0 to
/// kUnits - 1; the units are log-uniform from 2 mm to 4.4 m, each 1.5 times the one before: as
/// finely as a wrong one costs touches (docs/belief.md).
double unitOfLength(int index);

/// What one contact says about the unit.
struct LeverOfContact {
  double offset = 0.0;         ///< of its line of action from the object frame's origin [m]
  double offset_stddev = 0.0;  ///< error of the line there, on each axis across it [m]
  Vec3 origin = Vec3::Zero();  ///< of the object frame when it touched, in the map frame [m]
};

/// For each unit its probability, of sum 1: all equal before the first contact. Two things tell it:
/// - a contact's offset is Student's t with the unit and the line's error as scale, in one
/// dimension
///   across the line where the motion is `planar`, in two where it is not; or, with a small
///   probability, one of any size, since a push that is head on says nothing about how large things
///   are. Nor does a line that is known no better than a unit tell that unit from smaller ones;
/// - how far apart the object touches follows a Lomax distribution of shape 1, whose scale are some
///   units: its logarithm is as broad as it is while nobody knows how far things stand apart. All
///   pairs of contacts count, with the weight of one for each contact but the first.
/// Where the object's surface is `known` beforehand, by levers of contacts all over it, their mean
/// counts as a few contacts.
std::array<double, kUnits> unitProbabilities(const std::vector<LeverOfContact>& levers, bool planar,
                                             const std::vector<LeverOfContact>& known = {});

/// What the contacts say of a unit when they are explained at it [nats].
struct UnitEvidence {
  double cost = 0.0;       ///< of contradictions with free space, and of false contacts; >= 0
  double agreement = 0.0;  ///< how well the touches on the object foresee one another
};

/// The same where the contacts may be explained better at one unit than at another: `evidence` says
/// how well, at an index. It is asked for the units that worldsOfUnits takes of `by_levers` with so
/// many `strata`; where all of them cost more than the right one may, for smaller ones too, as long
/// as each explains the contacts better than the one before, until one costs no more.
/// Nothing contradicts a unit that is too small, which is why the levers go first. Matter that is
/// thin against the lever that it is touched with is found so: what is assumed to be thick cannot
/// stand where the object was free, and touches of a thin thing lie close together. How well
/// touches agree counts where a smaller unit was better. Where nothing contradicts the levers, they
/// are believed.
std::array<double, kUnits> probabilitiesByEvidence(
    const std::array<double, kUnits>& by_levers, int strata,
    const std::function<UnitEvidence(int index)>& evidence);

/// How many of `total` worlds have each unit: as many in each of `strata` parts of equal
/// probability, with the unit in the part's middle.
std::array<int, kUnits> worldsOfUnits(const std::array<double, kUnits>& probabilities, int total,
                                      int strata);

}  // namespace smore
