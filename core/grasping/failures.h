// What candidates for a grasp failed for.
#pragma once

#include <algorithm>
#include <array>

#include "core/types/grasp.h"

namespace fovea {

struct Failures {
  std::array<int, 9> counts{};  // by NoGrasp::Reason

  void Add(NoGrasp::Reason reason) { ++counts[static_cast<std::size_t>(reason)]; }

  void Add(const Failures& others) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += others.counts[i];
  }

  int NumOfMostCommon() const { return *std::max_element(counts.begin(), counts.end()); }

  // What the most failed for; `otherwise` where none was tried.
  NoGrasp::Reason MostCommon(NoGrasp::Reason otherwise) const {
    const auto most = std::max_element(counts.begin(), counts.end());
    return *most > 0 ? static_cast<NoGrasp::Reason>(most - counts.begin()) : otherwise;
  }
};

}  // namespace fovea
