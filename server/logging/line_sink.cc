#include "server/logging/line_sink.h"

#include <spdlog/fmt/fmt.h>

namespace fovea::server {

void LineSink::sink_it_(const spdlog::details::log_msg& message) {
  SayWhatWasDropped();
  if (dropped_ > 0 || !Write(message)) ++dropped_;
}

void LineSink::SayWhatWasDropped() {
  if (dropped_ == 0) return;
  const std::string text =
      fmt::format("{} lines dropped, since nobody took them from the log", dropped_);
  if (Write({spdlog::source_loc{}, "fovea", spdlog::level::warn, text})) dropped_ = 0;
}

bool LineSink::Write(const spdlog::details::log_msg& message) {
  spdlog::memory_buf_t line;
  formatter_->format(message, line);
  return writer_.Write({line.data(), line.size()});
}

}  // namespace fovea::server
