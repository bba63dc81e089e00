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

void Append(const std::vector<double>& from, std::vector<double>* to) {
  to->insert(to->end(), from.begin(), from.end());
}

Outcome Sum(const std::vector<Outcome>& outcomes) {
  Outcome all;
  for (const Outcome& one : outcomes) {
    all.sent += one.sent;
    all.dropped += one.dropped;
    Append(one.latency_ms, &all.latency_ms);
    Append(one.overhead_ms, &all.overhead_ms);
    Append(one.refusal_ms, &all.refusal_ms);
    for (const auto& [code, count] : one.errors) all.errors[code] += count;
  }
  return all;
}

}  // namespace

std::string Report(const std::vector<Outcome>& outcomes, double seconds) {
  const Outcome all = Sum(outcomes);
  std::size_t least = std::numeric_limits<std::size_t>::max(), most = 0;
  for (const Outcome& one : outcomes) {
    least = std::min(least, one.latency_ms.size());
    most = std::max(most, one.latency_ms.size());
  }
  std::string text =
      fmt::format("sent       {} frames\nanswered   {}, {:.2f} per second\n", all.sent,
                  all.latency_ms.size(), static_cast<double>(all.latency_ms.size()) / seconds) +
      fmt::format("latency    {}\noverhead   {}\n", Percentiles(all.latency_ms),
                  Percentiles(all.overhead_ms)) +
      fmt::format("dropped    {}\nfairness   {} to {} answers per robot\n", all.dropped, least,
                  most);
  for (const auto& [code, count] : all.errors) text += fmt::format("{}  {}\n", code, count);
  if (!all.refusal_ms.empty()) text += "refusals   " + Percentiles(all.refusal_ms) + "\n";
  if (outcomes.size() > 1) {
    text += "first      " + Percentiles(outcomes.front().latency_ms) + "\n";
    text +=
        "others     " + Percentiles(Sum({outcomes.begin() + 1, outcomes.end()}).latency_ms) + "\n";
  }
  return text;
}

}  // namespace fovea::load
