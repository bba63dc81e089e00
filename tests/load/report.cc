#include "tests/load/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fovea::load {
namespace {

// Sorts the values. NaN of none.
double Percentile(std::vector<double>* values, double share) {
  if (values->empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values->begin(), values->end());
  const auto rank =
      static_cast<std::size_t>(std::ceil(share * static_cast<double>(values->size())));
  return (*values)[std::max<std::size_t>(rank, 1) - 1];
}

std::string Percentiles(std::vector<double> values) {
  return fmt::format("p50 {:.1f}, p95 {:.1f}, p99 {:.1f} ms", Percentile(&values, 0.5),
                     Percentile(&values, 0.95), Percentile(&values, 0.99));
}

std::vector<Outcome> InRole(const std::vector<Outcome>& outcomes, const std::string& role) {
  std::vector<Outcome> found;
  for (const Outcome& one : outcomes) {
    if (one.role == role) found.push_back(one);
  }
  return found;
}

// What became of those in one role; nothing where there are none.
std::string Line(const char* title, const std::vector<Outcome>& outcomes) {
  if (outcomes.empty()) return "";
  const Outcome all = Sum(outcomes);
  return fmt::format("{:<10} {} of {} answered ({:.1f} %), {}\n", title, all.latency_ms.size(),
                     all.sent,
                     100.0 * static_cast<double>(all.latency_ms.size()) /
                         static_cast<double>(std::max<std::uint64_t>(all.sent, 1)),
                     Percentiles(all.latency_ms));
}

}  // namespace

std::string Report(const std::vector<Outcome>& outcomes, double seconds) {
  const Outcome all = Sum(outcomes);
  std::size_t least = std::numeric_limits<std::size_t>::max(), most = 0;
  for (const Outcome& one : outcomes) {
    if (!one.role.empty()) continue;
    least = std::min(least, one.latency_ms.size());
    most = std::max(most, one.latency_ms.size());
  }
  std::string text =
      fmt::format("sent       {} frames\nanswered   {}, {:.2f} per second\n", all.sent,
                  all.latency_ms.size(), static_cast<double>(all.latency_ms.size()) / seconds) +
      fmt::format("latency    {}\noverhead   {}\n", Percentiles(all.latency_ms),
                  Percentiles(all.overhead_ms)) +
      fmt::format("dropped    {}\n", all.dropped);
  if (least <= most) text += fmt::format("fairness   {} to {} answers per robot\n", least, most);
  if (all.lost > 0) text += fmt::format("lost       {}\n", all.lost);
  for (const auto& [code, count] : all.errors) text += fmt::format("{}  {}\n", code, count);
  if (!all.refusal_ms.empty()) text += "refusals   " + Percentiles(all.refusal_ms) + "\n";
  for (const char* role : {"often", "greedy", "slow", "vanishes"}) {
    text += Line(role, InRole(outcomes, role));
  }
  return text + Line("others", InRole(outcomes, ""));
}

}  // namespace fovea::load
