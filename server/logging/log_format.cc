#include "server/logging/log_format.h"

#include <spdlog/pattern_formatter.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <string_view>

namespace fovea::server {
namespace {

std::atomic<LogFormat> log_format = LogFormat::kText;

// ISO 8601 with the offset of the time zone.
constexpr const char* kTime = "%Y-%m-%dT%H:%M:%S.%e%z";

class JsonFormatter : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) override {
    spdlog::memory_buf_t head;
    head_.format(message, head);
    const std::string_view text(message.payload.data(), message.payload.size());
    std::string result(head.data(), head.size());
    if (text.starts_with(kMembersFollow)) {
      result += text.substr(1);
    } else {
      result +=
          "\"message\":" + nlohmann::json(text).dump(-1, ' ', /*ensure_ascii=*/false,
                                                     nlohmann::json::error_handler_t::replace);
    }
    result += "}\n";
    line.append(result.data(), result.data() + result.size());
  }

  std::unique_ptr<spdlog::formatter> clone() const override {
    return std::make_unique<JsonFormatter>();
  }

 private:
  spdlog::pattern_formatter head_{std::string("{\"time\":\"") + kTime + "\",\"level\":\"%l\",",
                                  spdlog::pattern_time_type::local, ""};
};

}  // namespace

LogFormat ParseLogFormat(const std::string& name) {
  return name == "json" ? LogFormat::kJson : LogFormat::kText;
}

LogFormat GetLogFormat() { return log_format; }

void SetLogFormat(LogFormat format) { log_format = format; }

std::unique_ptr<spdlog::formatter> MakeFormatter(LogFormat format) {
  if (format == LogFormat::kJson) return std::make_unique<JsonFormatter>();
  return std::make_unique<spdlog::pattern_formatter>(std::string(kTime) + " %l %v");
}

}  // namespace fovea::server
