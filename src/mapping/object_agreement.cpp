// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/object_agreement.h"

#include <cmath>

namespace smore {
namespace {

// Of a place that may be anywhere within a distance.
double evenDensity(double reach, bool planar) {
  return planar ? 1.0 / (M_PI * reach * reach) : 3.0 / (4.0 * M_PI * reach * reach * reach);
}

// The touches on the object in one sample; those before it foresee the next one.
class ForeseenTouches {
 public:
  explicit ForeseenTouches(const TouchLengths& lengths)
      : spread_(lengths.spread),
        peak_(lengths.planar ? 1.0 / (M_PI * spread_ * spread_)
                             : 1.0 / (M_PI * M_PI * spread_ * spread_ * spread_)),
        anywhere_(evenDensity(lengths.reach, lengths.planar)) {}

  /// Log density of the next touch, which then foresees others.
  double add(const Eigen::Vector3f& touch) {
    double density = anywhere_;
    for (const Eigen::Vector3f& before : touches_) {
      const double ratio = (touch - before).norm() / spread_;
      const double falling = 1.0 + ratio * ratio;
      density += peak_ / (falling * falling);
    }
    touches_.push_back(touch);
    return std::log(density / static_cast<double>(touches_.size()));
  }

 private:
  double spread_;
  double peak_;      ///< of a kernel that integrates to one
  double anywhere_;  ///< density of a touch that nothing foresees
  std::vector<Eigen::Vector3f> touches_;
};

}  // namespace

double objectAgreement(const std::vector<ContactHypotheses>& contacts,
                       const std::vector<JointSample>& samples, const TouchLengths& lengths,
                       int elsewhere) {
  const double of_false_contact = std::log(evenDensity(lengths.widest, lengths.planar));
  double sum = 0.0;
  for (const JointSample& sample : samples) {
    ForeseenTouches touches(lengths);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const int i = sample.places[k];
      sum += i == kFalseContact ? of_false_contact : touches.add(contacts[k].object.at(i));
    }
  }
  return sum / static_cast<double>(samples.size()) + elsewhere * of_false_contact;
}

}  // namespace smore
