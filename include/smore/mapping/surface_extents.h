// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "smore/mapping/forbidden_matter.h"
#include "smore/mapping/surface_normals.h"
#include "smore/mapping/surface_patch.h"
#include "smore/mapping/worlds_at_unit.h"

namespace smore {

/// Continues the touched surfaces of all sampled explanations until free space ends them: first the
/// object's against the touched places of the world, then the world's against the object so found.
///
/// How far surfaces go on is one unknown size of each explanation's world and, in planar motion,
/// one of its object, spread evenly over all orders of magnitude: a touch near a gap then closes it
/// in those worlds alone whose surfaces are as large, however many touches there are. In space the
/// object is mostly touched at corners, where its tangent planes are hardly in it; there its
/// surfaces are points, and the world's are turned as surfaceNormals says. What is known beforehand
/// is neither covered nor entered.
///
/// The object is in one piece, as what is held in one hand is: its touches are joined, and rings
/// closed as far as its surfaces go on. Its matter also goes on behind its surface, to one depth
/// for all of it, spread like the sizes: in planar motion behind all of each patch, in space in the
/// ball of that diameter that touches the surface there. The object is as thick as where it is
/// thinnest: where free space ends the matter straight behind any of its touches sooner, that is
/// the depth behind all of them.
class SurfaceExtents {
 public:
  SurfaceExtents(const WorldSamples& samples, const FeatureParameters& feature,
                 const ExtentParameters& extent, bool planar, std::uint64_t seed);

  const std::vector<MaskedPoint>& object() const { return object_.points(); }
  /// In space, the object's matter in the balls behind its touches; object() has what lies straight
  /// behind them. It ends no surface of the world.
  const std::vector<MaskedPoint>& behindObject() const { return behind_object_; }
  const std::vector<MaskedPoint>& world() const { return world_.points(); }

 private:
  void addTouches();
  struct Touch {
    const ContactHypotheses* contact;
    int place;  ///< of its places
  };
  /// Where this hypothesis claims matter of its own on that side: not at contacts that it holds to
  /// be false, nor on surfaces that it holds to be known.
  std::vector<Touch> touches(MapSide side, int hypothesis) const;
  void grow(MapSide side);
  std::vector<ForbiddenMatter> forbiddenFor(MapSide side) const;
  enum class Known {
    kIsNotTouched,  ///< what is known beforehand, matter or nothing, is not claimed once more
    kMatterGoesOn,  ///< known matter is matter
  };
  /// Those of the asked hypotheses in which no matter of that side may be centred at a point.
  HypothesisMask forbiddenAt(MapSide side, const Eigen::Vector3f& point, HypothesisMask asked,
                             const std::vector<ForbiddenMatter>& forbidden, Known known) const;
  MatterAllowed allowedFor(MapSide side, int hypothesis,
                           const std::vector<ForbiddenMatter>& forbidden, Known known) const;
  struct TouchedPatch {
    std::uint64_t id;  ///< of its contact
    SurfacePatch patch;
  };
  using TouchedByHypothesis = std::array<std::vector<TouchedPatch>, kHypotheses>;
  void fillBehind(const TouchedByHypothesis& touched,
                  const std::vector<ForbiddenMatter>& forbidden);
  std::vector<TouchedPoint> touchedPoints(MapSide side, const std::vector<Touch>& touches) const;
  std::vector<TouchedPatch> touchedPatches(MapSide side, int hypothesis,
                                           const MatterAllowed& behind) const;
  /// How deep the object is behind all of its touches [steps].
  int objectDepth(int hypothesis, const std::vector<TouchedPatch>& touched,
                  const MatterAllowed& behind) const;
  std::vector<Eigen::Vector3f> patches(MapSide side, int hypothesis,
                                       const std::vector<TouchedPatch>& touched,
                                       const MatterAllowed& allowed) const;
  std::vector<Eigen::Vector3f> joined(int hypothesis, const MatterAllowed& allowed) const;
  /// Whether its patches are more than points.
  bool goesOnAlong(MapSide side) const;
  double longestRadius(MapSide side) const;
  /// How far surfaces of that side go on in this hypothesis [m].
  double radiusOf(MapSide side, int hypothesis) const;
  /// Between neighbouring points of a patch [m].
  double stepOf() const;

  const WorldSamples& samples_;
  const FeatureParameters& feature_;
  const ExtentParameters& extent_;
  bool planar_;
  std::uint64_t seed_;
  MaskedPoints object_;
  std::vector<MaskedPoint> behind_object_;
  MaskedPoints world_;
};

}  // namespace smore
