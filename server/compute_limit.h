#pragma once

#include <chrono>
#include <stdexcept>
#include <string>

namespace fovea::server {

// A name among stage times that is no stage, but part of the times of the others: how long the
// frame's thread waited for a processor that other threads or programs had.
constexpr char kProcessorWait[] = "processor_wait";

// Thrown where a frame has used up the processor time that it may take.
class ComputeLimitPassed : public std::runtime_error {
 public:
  ComputeLimitPassed(const std::string& stage, std::chrono::milliseconds limit)
      : std::runtime_error("the frame took more than " + std::to_string(limit.count()) +
                           " ms of computing, this server's limit (--max-compute-ms), and was "
                           "given up in stage " +
                           stage + "; send a smaller image or region, or options that cost less") {}
};

// Of the processor time of the thread that made it, and of the time that it waited for helpers: a
// machine that is busy with other things is no fault of the frame.
class ComputeLimit {
 public:
  // 0: none.
  explicit ComputeLimit(std::chrono::milliseconds limit) : limit_(limit), start_(Used()) {}

  bool HasPassed() const { return limit_.count() > 0 && Used() - start_ > limit_; }

  // How long the thread could have gone on since, and got no processor: other threads had them.
  std::chrono::nanoseconds WaitedForProcessor() const;

 private:
  static std::chrono::nanoseconds Used();

  const std::chrono::milliseconds limit_;
  const std::chrono::nanoseconds start_;
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace fovea::server
