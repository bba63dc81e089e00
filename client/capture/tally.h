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

  void Replaced();
  // To be called before the picture is sent, so that its answer finds it.
  void Sent(Picture picture);
  // The picture with this number among those sent. Empty where there is none.
  std::optional<Picture> Answered(std::uint64_t sequence);
  // The time of a failure says nothing of how long answers take, and is not kept.
  void Count(bool failed, std::uint64_t objects, double latency_ms);
  void Gone(std::uint64_t dropped, std::uint64_t lost);
  // No more answers will come.
  void Finish();

  Counts Snapshot() const;
  std::vector<double> Latencies_ms() const;  // of what was answered

 private:
  mutable std::mutex mutex_;
  Counts counts_;
  std::vector<double> latencies_ms_;
  std::deque<Picture> waiting_;      // sent, not answered
  std::uint64_t first_waiting_ = 0;  // number of the first of them
};

// Where `share` of the sorted values lie at or below (nearest rank); 0 for none.
double Percentile(const std::vector<double>& sorted, double share);

// For people: what was captured, answered, dropped by whom, and how long it took.
std::string Summary(const Tally& tally, std::uint64_t num_captured, const CameraLosses& losses,
                    std::uint64_t num_reopened);

// "processor time of this client: 14.4 s in 120.0 s, 12 % of one core".
std::string CpuUse(double seconds);

}  // namespace fovea::capture
