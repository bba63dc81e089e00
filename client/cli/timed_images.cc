#include "client/cli/timed_images.h"

#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <tuple>

namespace fovea::cli {
namespace {

constexpr std::int64_t kFarthest_ns = 20'000'000;  // as TUM's own associate.py
constexpr std::int64_t kSecond_ns = 1'000'000'000;

std::optional<std::int64_t> WholeNumber(const std::string& text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

std::int64_t UnitOf(std::size_t num_digits) {
  if (num_digits <= 11) return kSecond_ns;
  if (num_digits <= 14) return 1'000'000;
  return num_digits <= 17 ? 1000 : 1;
}

bool Before(const TimedImage& a, const TimedImage& b) {
  return std::tie(a.time_ns, a.path) < std::tie(b.time_ns, b.path);
}

struct Candidate {
  std::int64_t apart_ns;
  std::size_t color, depth;
};

// All that are near enough, the closest first. Both sorted by time.
std::vector<Candidate> Candidates(const std::vector<TimedImage>& color,
                                  const std::vector<TimedImage>& depth) {
  constexpr std::size_t kMostPerImage = 8;  // of folders where all times are the same
  std::vector<Candidate> candidates;
  std::size_t first = 0;
  for (std::size_t i = 0; i < color.size(); ++i) {
    const std::int64_t time = color[i].time_ns;
    while (first < depth.size() && depth[first].time_ns < time - kFarthest_ns) ++first;
    for (std::size_t j = first; j < depth.size() && j < first + kMostPerImage; ++j) {
      if (depth[j].time_ns > time + kFarthest_ns) break;
      candidates.push_back({std::abs(depth[j].time_ns - time), i, j});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.apart_ns, a.color, a.depth) < std::tie(b.apart_ns, b.color, b.depth);
  });
  return candidates;
}

}  // namespace

std::optional<std::int64_t> ParseTime(const std::string& text) {
  const std::size_t dot = text.find('.');
  const std::string whole = text.substr(0, dot);
  const auto number = WholeNumber(whole);
  if (!number) return std::nullopt;
  if (dot == std::string::npos) {
    const std::int64_t unit = UnitOf(whole.size());
    return *number > INT64_MAX / unit ? std::nullopt : std::optional(*number * unit);
  }
  std::string fraction = text.substr(dot + 1);
  if (fraction.empty() || *number > INT64_MAX / kSecond_ns - 1) return std::nullopt;
  if (!std::all_of(fraction.begin(), fraction.end(), [](unsigned char c) { return isdigit(c); })) {
    return std::nullopt;
  }
  fraction.resize(9, '0');
  return *number * kSecond_ns + *WholeNumber(fraction);
}

FrameList PairByTime(std::vector<TimedImage> color, std::vector<TimedImage> depth) {
  std::sort(color.begin(), color.end(), Before);
  std::sort(depth.begin(), depth.end(), Before);
  std::vector<std::optional<std::size_t>> partner(color.size());
  std::vector<bool> taken(depth.size(), false);
  std::size_t num_pairs = 0;
  for (const Candidate& candidate : Candidates(color, depth)) {
    if (partner[candidate.color] || taken[candidate.depth]) continue;
    partner[candidate.color] = candidate.depth;
    taken[candidate.depth] = true;
    ++num_pairs;
  }
  FrameList list;
  for (std::size_t i = 0; i < color.size(); ++i) {
    if (!partner[i]) continue;
    list.frames.push_back(
        {color[i].name, color[i].path, depth[*partner[i]].path,
         google::protobuf::util::TimeUtil::NanosecondsToTimestamp(color[i].time_ns)});
  }
  const auto note = [&](std::size_t number, const char* what, const char* other) {
    if (number == 0) return;
    list.notes.push_back(std::to_string(number) + " " + what + " without " + other +
                         " within 20 ms");
  };
  note(color.size() - num_pairs, "colour images", "depth");
  note(depth.size() - num_pairs, "depth images", "colour");
  return list;
}

}  // namespace fovea::cli
