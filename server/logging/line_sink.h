#pragma once

#include <spdlog/sinks/base_sink.h>

#include <mutex>

#include "server/logging/line_writer.h"

namespace fovea::server {

// Where log lines go. Neither a reader that stalls nor one that is gone holds up whoever logs; how
// many lines that cost is said when there is room again.
class LineSink : public spdlog::sinks::base_sink<std::mutex> {
 public:
  explicit LineSink(int fd) : writer_(fd) {}

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override;
  // Says what was dropped, if there is room.
  void flush_() override { SayWhatWasDropped(); }

 private:
  void SayWhatWasDropped();
  bool Write(const spdlog::details::log_msg& message);

  LineWriter writer_;
  std::uint64_t dropped_ = 0;  // not said yet
};

}  // namespace fovea::server
