// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/method_kind.h"

#include <array>

#include "smore/common/result.h"

namespace smore {
namespace {

constexpr std::array kMethodKinds = {MethodKind::kPaper, MethodKind::kCspace, MethodKind::kSmore,
                                     MethodKind::kBlocked, MethodKind::kChs};

}  // namespace

MethodKind methodKind(const std::string& name) {
  std::string names;
  for (const MethodKind kind : kMethodKinds) {
    if (methodName(kind) == name) return kind;
    names += (names.empty() ? "" : ", ") + methodName(kind);
  }
  throw InputError("unknown method '" + name + "'; use one of " + names);
}

std::vector<std::string> methodNames() {
  std::vector<std::string> names;
  names.reserve(kMethodKinds.size());
  for (const MethodKind kind : kMethodKinds) names.push_back(methodName(kind));
  return names;
}

std::string methodName(MethodKind kind) {
  switch (kind) {
    case MethodKind::kPaper:
      return "paper";
    case MethodKind::kCspace:
      return "cspace";
    case MethodKind::kSmore:
      return "smore";
    case MethodKind::kBlocked:
      return "blocked";
    case MethodKind::kChs:
      return "chs";
  }
  return "unknown";
}

}  // namespace smore
