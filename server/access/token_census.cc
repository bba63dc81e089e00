#include "server/access/token_census.h"

#include <spdlog/spdlog.h>

#include "server/logging/log_record.h"

namespace fovea::server {
namespace {

constexpr std::chrono::days kWithin{14};

std::string Named(const std::string& title, const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMost; ++i) {
    text += (i == 0 ? "; " + title + ": " : ", ") + Harmless(names[i]);
  }
  if (names.size() > kMost) text += fmt::format(" and {} more", names.size() - kMost);
  return text;
}

}  // namespace

void TokenCensus::Add(const std::string& name, std::chrono::sys_seconds expires) {
  ++all_;
  if (expires <= now_) {
    expired_.push_back(name);
  } else if (expires - now_ < kWithin) {
    soon_.push_back(name);
  }
}

std::string TokenCensus::Text() const {
  return fmt::format("{} token{}{}{}", all_, all_ == 1 ? "" : "s", Named("expired", expired_),
                     Named(fmt::format("within {} days", kWithin.count()), soon_));
}

void TokenCensus::Log(const std::string& flag, const std::string& file, bool also_good) const {
  if (!is_due() && !also_good) return;
  spdlog::log(is_due() ? spdlog::level::warn : spdlog::level::info, "{}: {} holds {}", flag, file,
              Text());
}

}  // namespace fovea::server
