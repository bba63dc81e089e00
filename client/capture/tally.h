#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "client/capture/camera.h"
#include "client/capture/picture.h"

namespace fovea::capture {

// What became of the pictures of a run. Thread-safe.
class Tally {
 public:
  struct Counts {
    std::uint64_t replaced = 0;  // by a newer one, before they could be sent
    std::uint64_t sent = 0, answered = 0, failed = 0;
    std::uint64_t dropped = 0;  // by the server, for a newer one
    std::uint64_t lost = 0;     // with a connection that broke, or unanswered at the end
    std::uint64_t objects = 0;
  };

  // Of the pictures that wait for their answers the newest keep their images, up to so many bytes.
  explicit Tally(std::size_t max_image_bytes = std::size_t{256} << 20U)
      : max_image_bytes_(max_image_bytes) {}

  void Replaced();
  // To be called before the picture is sent, so that its answer finds it.
  void Sent(Picture picture);
  // The last one could not be: it is lost, and no answer will ask for it.
  void NotSent();
  // The picture with this number among those sent, where it waited for too long without its images.
  // Empty where there is none.
  std::optional<Picture> Answered(std::uint64_t sequence);
  // The time of a failure says nothing of how long answers take, and is not kept.
  void Count(bool failed, std::uint64_t objects, double latency_ms);
  void Gone(std::uint64_t dropped, std::uint64_t lost);
  // No more answers will come.
  void Finish();

  Counts Snapshot() const;
  std::vector<double> Latencies_ms() const;  // of what was answered

 private:
  struct Waiting {
    std::uint64_t sequence = 0;
    Picture picture;
  };

  const std::size_t max_image_bytes_;
  mutable std::mutex mutex_;
  Counts counts_;
  std::vector<double> latencies_ms_;
  std::deque<Waiting> waiting_;  // sent, not answered
};

// Where `share` of the sorted values lie at or below (nearest rank); 0 for none.
double Percentile(const std::vector<double>& sorted, double share);

// For people: what was captured, answered, dropped by whom, and how long it took.
std::string Summary(const Tally& tally, std::uint64_t num_captured, const CameraLosses& losses,
                    std::uint64_t num_reopened);

// "processor time of this client: 14.4 s in 120.0 s, 12 % of one core".
std::string CpuUse(double seconds);

}  // namespace fovea::capture
