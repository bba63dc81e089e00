#include "client/observer/history/bundling.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <utility>

#include "client/bundle/bundle.h"

namespace fovea::observer {
namespace {

using google::protobuf::util::TimeUtil;

constexpr std::uint64_t kSecond = 1'000'000, kMaxSeconds = 600;
constexpr std::size_t kMaxFrames = 64, kMaxBytes = std::size_t{32} << 20;

std::optional<std::uint64_t> SecondsOf(const std::string& text) {
  if (text.empty()) return 0;
  const auto seconds = NumberOf(text);
  if (!seconds || *seconds > kMaxSeconds) return std::nullopt;
  return *seconds * kSecond;
}

// Of what was sent and answered: answers with clouds and pictures of the steps are larger than
// frames.
std::size_t SizeOf(const v1::WatchedFrame& frame) {
  return frame.frame().ByteSizeLong() + frame.answer().ByteSizeLong();
}

std::uint64_t Between(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : b - a; }

// Nearest to the moment first.
std::vector<std::uint64_t> IdsOf(const std::vector<History::Entry>& entries, const Moment& moment) {
  if (entries.empty()) return {};
  const auto middle = std::ranges::min_element(
      entries, {}, [&](const auto& each) { return Between(each.id, moment.at); });
  std::vector<std::uint64_t> ids;
  for (const History::Entry& entry : entries) {
    const bool is_inside =
        entry.id + moment.before >= middle->id && entry.id <= middle->id + moment.after;
    if (is_inside) ids.push_back(entry.id);
  }
  std::ranges::sort(ids, {}, [&](std::uint64_t id) { return Between(id, middle->id); });
  return ids;
}

bundle::BundledFrame FrameOf(HistoryRecord record) {
  v1::WatchedFrame& watched = record.frame;
  bundle::BundledFrame frame{.robot = record.header.robot,
                             .server = record.header.server,
                             .server_version = record.header.version};
  frame.took_ms = static_cast<double>(TimeUtil::DurationToMicroseconds(watched.took())) / 1000;
  frame.answered_at = std::chrono::system_clock::time_point(
      std::chrono::microseconds(TimeUtil::TimestampToMicroseconds(watched.answered_at())));
  frame.request.mutable_frame()->Swap(watched.mutable_frame());
  frame.request.mutable_options()->Swap(watched.mutable_options());
  if (watched.has_answer()) frame.answer = std::move(*watched.mutable_answer());
  if (watched.has_error()) frame.error = std::move(*watched.mutable_error());
  return frame;
}

std::string NameOf(const std::string& robot, const bundle::BundledFrame& frame) {
  constexpr std::size_t kMost = 64;
  std::string plain = robot.substr(0, kMost);
  for (char& c : plain) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-';
    if (!is_plain) c = '_';
  }
  return fmt::format("fovea_{}_{:%Y%m%dT%H%M%S}Z.zip", plain,
                     std::chrono::floor<std::chrono::seconds>(frame.answered_at));
}

}  // namespace

std::optional<Moment> MomentOf(const HttpRequest& request) {
  const auto at = NumberOf(request.Query("at"));
  const auto before = SecondsOf(request.Query("before")), after = SecondsOf(request.Query("after"));
  constexpr std::uint64_t kLatest = std::uint64_t{1} << 62U;
  if (!at || *at > kLatest || !before || !after) return std::nullopt;
  return Moment{.at = *at, .before = *before, .after = *after};
}

std::optional<BundleFile> BundleOf(const History& history, const std::string& robot,
                                   const std::vector<History::Entry>& entries,
                                   const Moment& moment) {
  const std::vector<std::uint64_t> ids = IdsOf(entries, moment);
  std::vector<bundle::BundledFrame> frames;
  std::size_t bytes = 0, num_left_out = 0;
  for (const std::uint64_t id : ids) {
    auto record = frames.size() < kMaxFrames ? history.Read(robot, id) : std::nullopt;
    const std::size_t size = record ? SizeOf(record->frame) : 0;
    if (!record || (bytes + size > kMaxBytes && !frames.empty())) {
      ++num_left_out;
      continue;
    }
    bytes += size;
    frames.push_back(FrameOf(std::move(*record)));
  }
  if (frames.empty()) return std::nullopt;
  const std::string name = NameOf(robot, frames.front());
  const auto answered_at =
      std::chrono::floor<std::chrono::milliseconds>(frames.front().answered_at.time_since_epoch());
  std::ranges::sort(frames, {}, &bundle::BundledFrame::answered_at);
  return BundleFile{
      .name = name,
      .answered_at = answered_at,
      .bytes = bundle::WriteBundle(std::move(frames), {.made_by = "fovea-observer " FOVEA_VERSION,
                                                       .num_left_out = num_left_out})};
}

}  // namespace fovea::observer
