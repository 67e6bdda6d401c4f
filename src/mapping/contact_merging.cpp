// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/contact_merging.h"

#include <algorithm>
#include <numeric>

namespace smore {
namespace {

class Coverage {
 public:
  Coverage(const std::vector<ContactHypotheses>& contacts,
           const std::vector<Explanation>& explanations, const DistributionParameters& parameters)
      : contacts_(contacts),
        explanations_(explanations),
        object_(parameters.object),
        world_(parameters.world) {}

  /// How well the contacts `others` say what contact k says, from 0 to 1.
  float of(int k, const std::vector<int>& others) const {
    float sum = 0.0F;
    for (const Explanation& explanation : explanations_) sum += in(explanation, k, others);
    return sum / static_cast<float>(explanations_.size());
  }

 private:
  float in(const Explanation& explanation, int k, const std::vector<int>& others) const {
    if (explanation[k] == kFalseContact) return 1.0F;
    float object = 0.0F;
    float world = 0.0F;
    for (const int l : others) {
      if (l == k || explanation[l] == kFalseContact) continue;
      object = std::max(object, object_(contacts_[k].object.at(explanation[k]) -
                                            contacts_[l].object.at(explanation[l]),
                                        contacts_[k].object_normal.at(explanation[k]),
                                        contacts_[l].object_normal.at(explanation[l])));
      world = std::max(world, world_(contacts_[k].world.at(explanation[k]) -
                                         contacts_[l].world.at(explanation[l]),
                                     contacts_[k].world_normal.at(explanation[k]),
                                     contacts_[l].world_normal.at(explanation[l])));
    }
    return std::min(object, world);
  }

  const std::vector<ContactHypotheses>& contacts_;
  const std::vector<Explanation>& explanations_;
  AttractionKernel object_;
  AttractionKernel world_;
};

}  // namespace

std::vector<int> coveredContacts(const std::vector<ContactHypotheses>& contacts,
                                 const std::vector<Explanation>& explanations,
                                 const DistributionParameters& parameters, int count) {
  const Coverage coverage(contacts, explanations, parameters);
  std::vector<int> kept(contacts.size());
  std::iota(kept.begin(), kept.end(), 0);
  std::vector<int> covered;
  while (static_cast<int>(covered.size()) < count && !kept.empty()) {
    std::vector<std::pair<float, std::uint64_t>> scores;  // ids decide between equals
    scores.reserve(kept.size());
    for (const int k : kept) scores.emplace_back(coverage.of(k, kept), contacts[k].id);
    const auto most = std::max_element(scores.begin(), scores.end()) - scores.begin();
    covered.push_back(kept[most]);
    kept.erase(kept.begin() + most);
  }
  return covered;
}

}  // namespace smore
