#pragma once

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "server/logging/log_limiter.h"

namespace fovea::testing {

// What is logged while it lives, however much was before it. A line that holds `fails_at` is not:
// it throws what spdlog hands on.
class CapturedLog {
 public:
  explicit CapturedLog(const std::string& fails_at = "")
      : text_(std::make_shared<Text>(fails_at)), before_(spdlog::default_logger()) {
    server::LogLimiter::Global().Summarize(server::LogLimiter::Clock::time_point::max());
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("captured", text_));
  }
  ~CapturedLog() { spdlog::set_default_logger(before_); }

  CapturedLog(const CapturedLog&) = delete;
  CapturedLog& operator=(const CapturedLog&) = delete;

  std::string text() const { return text_->text(); }
  // Returns once the log holds it.
  void Await(const std::string& text) const { text_->Await(text); }

 private:
  class Text : public spdlog::sinks::base_sink<std::mutex> {
   public:
    explicit Text(std::string fails_at) : fails_at_(std::move(fails_at)) {}
    std::string text() {
      const std::lock_guard lock(mutex_);
      return text_;
    }
    void Await(const std::string& text) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return text_.find(text) != std::string::npos; });
    }

   protected:
    void sink_it_(const spdlog::details::log_msg& message) override {
      spdlog::memory_buf_t line;
      formatter_->format(message, line);
      const std::string_view view(line.data(), line.size());
      if (!fails_at_.empty() && view.find(fails_at_) != view.npos) throw 1;
      text_.append(line.data(), line.size());
      changed_.notify_all();
    }
    void flush_() override {}

   private:
    const std::string fails_at_;
    std::string text_;
    std::condition_variable changed_;
  };

  const std::shared_ptr<Text> text_;
  const std::shared_ptr<spdlog::logger> before_;
};

}  // namespace fovea::testing
