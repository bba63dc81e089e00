#include "core/objects/rejection.h"

#include <algorithm>
#include <string>

#include "core/types/pixels.h"

namespace fovea {
namespace {

// Not 0 for each node that is chosen, lies within a chosen one or has one within it.
std::vector<char> TouchedBy(const MergeTree& tree, const std::vector<int>& chosen) {
  std::vector<char> touched(tree.nodes.size(), 0);
  for (const int node : chosen) touched[node] = 1;
  std::vector<char> within = touched;
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const int parent = tree.nodes[n].parent;
    if (parent >= 0 && within[parent]) within[n] = 1;
  }
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    if (touched[n] && tree.nodes[n].parent >= 0) touched[tree.nodes[n].parent] = 1;
    touched[n] |= within[n];
  }
  return touched;
}

}  // namespace

std::vector<RejectedObject> FindRejected(const MergeTree& tree, const std::vector<int>& chosen,
                                         const std::vector<ObjectEvidence>& evidence,
                                         const std::vector<double>& probabilities,
                                         const ObjectModel& model) {
  const std::vector<char> touched = TouchedBy(tree, chosen);
  std::vector<int> likeliest(tree.nodes.size());  // within each node
  std::vector<RejectedObject> rejected;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const MergeNode& node = tree.nodes[n];
    likeliest[n] = static_cast<int>(n);
    for (const int child : {node.left, node.right}) {
      if (child < 0) continue;
      if (probabilities[likeliest[child]] > probabilities[likeliest[n]]) {
        likeliest[n] = likeliest[child];
      }
    }
    const bool is_largest = node.parent < 0 || touched[node.parent];
    const ObjectEvidence& of_it = evidence[likeliest[n]];
    if (touched[n] || !is_largest || of_it.num_pixels < kFewestPixels) continue;
    rejected.push_back({of_it.bounds_px, static_cast<float>(probabilities[likeliest[n]]),
                        std::string(NameOf(model.StrongestAgainst(TermsOf(of_it))))});
  }
  return rejected;
}

void KeepLikeliest(std::vector<RejectedObject>& rejected) {
  constexpr std::size_t kMost = 100;
  std::stable_sort(rejected.begin(), rejected.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  if (rejected.size() > kMost) rejected.resize(kMost);
}

}  // namespace fovea
