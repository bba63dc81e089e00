// Which colour image belongs to which depth image: those of one moment by the camera's clock.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

namespace fovea::capture {

// Takes the frames of both streams in any interleaving, each stream in its own order. A frame may
// come late, after a few later ones of the other stream.
template <typename Frame>
class Pairing {
 public:
  struct Pair {
    Frame color, depth;
    std::uint64_t depth_time_us = 0;
  };

  // Frames further apart than `tolerance_us` are of different moments.
  explicit Pairing(std::uint64_t tolerance_us) : tolerance_us_(tolerance_us) {}

  std::optional<Pair> AddColor(std::uint64_t time_us, Frame frame) {
    auto partner = Match(time_us, depth_);
    if (!partner) return Keep(time_us, std::move(frame), color_);
    num_unpaired_ += std::exchange(color_, {}).size();
    return Pair{std::move(frame), std::move(partner->frame), partner->time_us};
  }

  std::optional<Pair> AddDepth(std::uint64_t time_us, Frame frame) {
    auto partner = Match(time_us, color_);
    if (!partner) return Keep(time_us, std::move(frame), depth_);
    num_unpaired_ += std::exchange(depth_, {}).size();
    return Pair{std::move(partner->frame), std::move(frame), time_us};
  }

  // Frames that were given up because their partner never came.
  std::uint64_t NumUnpaired() const { return num_unpaired_; }

 private:
  // How many wait for a partner: more is no delay any more but a loss.
  static constexpr std::size_t kMaxWaiting = 4;

  struct Waiting {
    std::uint64_t time_us;
    Frame frame;
  };

  // Takes the first frame of that moment out of `others`, and those before it, which are too old.
  std::optional<Waiting> Match(std::uint64_t time_us, std::deque<Waiting>& others) {
    for (std::size_t i = 0; i < others.size(); ++i) {
      const std::uint64_t other_us = others[i].time_us;
      if ((time_us > other_us ? time_us - other_us : other_us - time_us) > tolerance_us_) continue;
      Waiting found = std::move(others[i]);
      others.erase(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      num_unpaired_ += i;
      return found;
    }
    return std::nullopt;
  }

  std::optional<Pair> Keep(std::uint64_t time_us, Frame frame, std::deque<Waiting>& own) {
    own.push_back({time_us, std::move(frame)});
    if (own.size() > kMaxWaiting) {
      own.pop_front();
      ++num_unpaired_;
    }
    return std::nullopt;
  }

  const std::uint64_t tolerance_us_;
  std::deque<Waiting> color_, depth_;
  std::uint64_t num_unpaired_ = 0;
};

}  // namespace fovea::capture
