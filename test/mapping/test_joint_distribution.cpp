// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "at_a_decimetre.h"
#include "smore/mapping/counter_random.h"
#include "smore/mapping/joint_distribution.h"

namespace smore {
namespace {

constexpr int kPlaces = 4;
constexpr int kContacts = 4;

const PriorEvidence kNothingKnown;

// A small world: few contacts with few places each, so that all explanations can be listed.
struct SmallCase {
  std::vector<ContactHypotheses> contacts;
  FreeSpaceEvidence evidence{atADecimetre().free_space, atADecimetre().feature.conflictDistance()};
};

Vec3 randomPoint(double span, std::mt19937* random) {
  std::uniform_real_distribution<double> uniform(-span, span);
  return {uniform(*random), uniform(*random), 0.0};
}

// Places lie in a box so small that attraction and conflicts of all strengths occur.
std::unique_ptr<SmallCase> randomCase(unsigned seed, int free_poses) {
  constexpr double kSpan = 0.12;
  std::mt19937 random(seed);
  auto result = std::make_unique<SmallCase>();
  for (int k = 0; k < kContacts; ++k) {
    ContactHypotheses contact;
    contact.count = kPlaces;
    contact.id = mixBits(seed, k);
    for (int i = 0; i < kPlaces; ++i) {
      contact.object.set(i, randomPoint(kSpan, &random));
      contact.world.set(i, randomPoint(kSpan, &random));
      contact.log_prior[i] = static_cast<float>(-std::log(kPlaces));
    }
    result->contacts.push_back(contact);
    result->evidence.insertContact(k, contact);
  }
  for (int i = 0; i < free_poses; ++i)
    result->evidence.addPose(makePose(randomPoint(kSpan, &random)));
  return result;
}

// Of two contacts' places on one side, for one another.
float pullOf(const AttractionKernel& kernel, const PointArray& place, const PointArray& normal,
             int i, const PointArray& other_place, const PointArray& other_normal, int j) {
  return kernel(place.at(i) - other_place.at(j), normal.at(i), other_normal.at(j));
}

// Unnormalised log probability of an explanation where nothing is known beforehand: docs/belief.md
// (B4).
double logDensity(const Explanation& explanation, const SmallCase& small,
                  const DistributionParameters& parameters) {
  const AttractionKernel on_object(parameters.object);
  const AttractionKernel in_world(parameters.world);
  double result = -parameters.conflict_cost * contradictions(explanation, small.evidence);
  for (int k = 0; k < kContacts; ++k) {
    const int i = explanation[k];
    const ContactHypotheses& a = small.contacts[k];
    result += i == kFalseContact ? std::log(parameters.false_contact)
                                 : a.log_prior[i] + std::log1p(-parameters.false_contact);
    double object = 0.0;
    double world = 0.0;
    for (int l = 0; l < kContacts && i != kFalseContact; ++l) {
      const int j = explanation[l];
      if (l == k || j == kFalseContact) continue;
      const ContactHypotheses& b = small.contacts[l];
      object += pullOf(on_object, a.object, a.object_normal, i, b.object, b.object_normal, j);
      world += pullOf(in_world, a.world, a.world_normal, i, b.world, b.world_normal, j);
    }
    result += parameters.exponent * (std::log1p(object / parameters.object.base) +
                                     std::log1p(world / parameters.world.base));
  }
  return result;
}

// Every explanation, with false contacts, and its exact probability.
struct Enumeration {
  std::vector<Explanation> explanations;
  std::vector<double> probabilities;

  double marginal(int contact, int place) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < explanations.size(); ++i) {
      if (explanations[i][contact] == place) sum += probabilities[i];
    }
    return sum;
  }
};

Enumeration enumerate(const SmallCase& small, const DistributionParameters& parameters) {
  Enumeration result;
  const int states = static_cast<int>(std::pow(kPlaces + 1, kContacts));
  double total = 0.0;
  for (int state = 0; state < states; ++state) {
    Explanation explanation;
    for (int k = 0, left = state; k < kContacts; ++k, left /= kPlaces + 1) {
      explanation.push_back(static_cast<std::int16_t>(left % (kPlaces + 1) - 1));
    }
    result.explanations.push_back(explanation);
    result.probabilities.push_back(std::exp(logDensity(explanation, small, parameters)));
    total += result.probabilities.back();
  }
  for (double& probability : result.probabilities) probability /= total;
  return result;
}

// Share of the samples of each (contact, place + 1).
std::vector<double> sampledMarginals(const JointDistribution& distribution, int samples) {
  std::vector<double> shares(kContacts * (kPlaces + 1), 0.0);
  for (const JointSample& sample : distribution.sample(samples, 7)) {
    for (int k = 0; k < kContacts; ++k) {
      shares[k * (kPlaces + 1) + sample.places[k] + 1] += 1.0 / samples;
    }
  }
  return shares;
}

TEST(JointDistribution, SamplesAgreeWithEnumeration) {
  constexpr int kSamples = 2000;
  DistributionParameters parameters = atADecimetre().distribution;
  parameters.conflict_cost = 2.0;  // low walls between explanations, so that 20 sweeps mix
  parameters.sweeps = 20;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto small = randomCase(seed, 4);
    const JointDistribution distribution(small->contacts, small->evidence, kNothingKnown,
                                         parameters);
    const Enumeration exact = enumerate(*small, parameters);
    const std::vector<double> sampled = sampledMarginals(distribution, kSamples);
    for (int k = 0; k < kContacts; ++k) {
      for (int i = -1; i < kPlaces; ++i) {
        // Four standard deviations of a share of 2000 near one half.
        EXPECT_NEAR(sampled[k * (kPlaces + 1) + i + 1], exact.marginal(k, i), 0.045)
            << "seed " << seed << " contact " << k << " place " << i;
      }
    }
  }
}

double logLoss(double probability, bool truth) {
  const double p = std::clamp(probability, 0.005, 0.995);
  return -std::log(truth ? p : 1.0 - p);
}

// 50 random cases of 20 observations. The truth is drawn from the exact posterior, so that no
// belief can do better than that on average.
TEST(JointDistribution, LogLossOf64SamplesIsNearTheExactPosteriors) {
  double exact_loss = 0.0;
  double sampled_loss = 0.0;
  std::mt19937 random(3);
  const DistributionParameters parameters = atADecimetre().distribution;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto small = randomCase(100 + seed, 20 - kContacts);
    const JointDistribution distribution(small->contacts, small->evidence, kNothingKnown,
                                         parameters);
    const Enumeration exact = enumerate(*small, parameters);
    const std::vector<double> sampled = sampledMarginals(distribution, 64);
    std::discrete_distribution<int> draw(exact.probabilities.begin(), exact.probabilities.end());
    const Explanation truth = exact.explanations[draw(random)];
    for (int k = 0; k < kContacts; ++k) {
      for (int i = -1; i < kPlaces; ++i) {
        exact_loss += logLoss(exact.marginal(k, i), truth[k] == i);
        sampled_loss += logLoss(sampled[k * (kPlaces + 1) + i + 1], truth[k] == i);
      }
    }
  }
  RecordProperty("exact", std::to_string(exact_loss / (50 * kContacts * (kPlaces + 1))));
  RecordProperty("sampled", std::to_string(sampled_loss / (50 * kContacts * (kPlaces + 1))));
  EXPECT_LE(sampled_loss, 1.1 * exact_loss);
}

TEST(AttractionKernel, OfSurfacesReachesAlongThemAndNotAcross) {
  const AttractionKernel kernel({AttractionShape::kSurface, 0.05, 0.05});
  const Eigen::Vector3f normal = Eigen::Vector3f::UnitX();
  EXPECT_FLOAT_EQ(kernel(Eigen::Vector3f::Zero(), normal, normal), 1.0F);
  // Six scales along the surface: 1 / (1 + 36); as many above it: 1 / (1 + 36)^3.
  EXPECT_FLOAT_EQ(kernel({0, 0.3F, 0}, normal, normal), 1.0F / 37.0F);
  EXPECT_FLOAT_EQ(kernel({0.3F, 0, 0}, normal, normal), 1.0F / (37.0F * 37.0F * 37.0F));
  // Symmetric, and one surface says as much as the other.
  const Eigen::Vector3f other = Eigen::Vector3f::UnitY();
  const Eigen::Vector3f between(0.1F, 0.02F, -0.05F);
  EXPECT_FLOAT_EQ(kernel(between, normal, other), kernel(-between, other, normal));
}

TEST(AttractionKernel, OfPointsEndsAtSixScales) {
  const AttractionKernel kernel({AttractionShape::kPoint, 0.03, 0.1});
  const Eigen::Vector3f normal = Eigen::Vector3f::UnitX();
  EXPECT_NEAR(kernel(Eigen::Vector3f::Zero(), normal, normal), 1.0F, 1e-3F);
  EXPECT_GT(kernel({0.17F, 0, 0}, normal, normal), 0.0F);
  EXPECT_EQ(kernel({0.19F, 0, 0}, normal, normal), 0.0F);
}

TEST(Contradictions, OfAContactWithItselfCountTwice) {
  const auto without = randomCase(5, 0);
  const auto with = randomCase(5, 0);
  // At this pose the first contact's own balls at place 0 coincide.
  const Eigen::Vector3f shift = with->contacts[0].world.at(0) - with->contacts[0].object.at(0);
  with->evidence.addPose(makePose(shift.cast<double>()));
  const Explanation own = {0, kFalseContact, kFalseContact, kFalseContact};
  EXPECT_EQ(contradictions(own, without->evidence), 0);
  EXPECT_EQ(contradictions(own, with->evidence), 2);
}

TEST(JointDistribution, TheOrderOfContactsDoesNotChangeASample) {
  const auto small = randomCase(9, 6);
  SmallCase reversed;
  for (int k = kContacts - 1; k >= 0; --k) {
    reversed.contacts.push_back(small->contacts[k]);
    reversed.evidence.insertContact(kContacts - 1 - k, small->contacts[k]);
  }
  std::mt19937 random(9);
  for (int i = 0; i < 6; ++i)
    reversed.evidence.addPose(Pose(small->evidence.poses()[i].cast<double>()));
  auto forward = JointDistribution(small->contacts, small->evidence, kNothingKnown,
                                   atADecimetre().distribution)
                     .sample(20, 1);
  const auto backward = JointDistribution(reversed.contacts, reversed.evidence, kNothingKnown,
                                          atADecimetre().distribution)
                            .sample(20, 1);
  for (std::size_t m = 0; m < forward.size(); ++m) {
    std::reverse(forward[m].places.begin(), forward[m].places.end());
    EXPECT_EQ(forward[m].places, backward[m].places);
  }
}

}  // namespace
}  // namespace smore
