#include "client/observer/sessions.h"

#include <fmt/format.h>
#include <openssl/rand.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace fovea::observer {
namespace {

constexpr std::size_t kMaxSessions = 256;
constexpr std::chrono::hours kMaxIdle{12};
constexpr std::chrono::seconds kPatience{4};

}  // namespace

std::string RandomName() {
  std::array<unsigned char, 32> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1) {
    throw std::runtime_error("no random numbers");
  }
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

std::shared_ptr<Feed> Sessions::FeedOf(const std::string& token) {
  const std::lock_guard lock(mutex_);
  std::erase_if(feeds_, [](const auto& each) { return each.second.expired(); });
  std::weak_ptr<Feed>& known = feeds_[token];
  auto feed = known.lock();
  if (!feed) known = feed = std::make_shared<Feed>(servers_, token, history_);
  return feed;
}

std::optional<Session> Sessions::LogIn(const std::string& token, std::string* problem) {
  const std::shared_ptr<Feed> feed = FeedOf(token);
  feed->AwaitAnswer(kPatience);
  if (!feed->board().Who()) {
    *problem = feed->board().IsRefused()
                   ? "no server knows this token (" + feed->board().Refusal() + ")"
                   : "no server can be reached; try again";
    return std::nullopt;
  }
  Session session{.id = RandomName(),
                  .csrf = RandomName(),
                  .feed = feed,
                  .used = std::chrono::steady_clock::now()};
  const std::lock_guard lock(mutex_);
  if (sessions_.size() >= kMaxSessions) {
    End(std::ranges::min_element(sessions_, {}, [](const auto& each) { return each.second.used; }));
  }
  sessions_[session.id] = session;
  return session;
}

std::optional<Session> Sessions::Find(const std::string& id) {
  const auto now = std::chrono::steady_clock::now();
  const std::lock_guard lock(mutex_);
  const auto found = sessions_.find(id);
  if (found == sessions_.end()) return std::nullopt;
  if (now - found->second.used > kMaxIdle || found->second.feed->board().IsRefused()) {
    End(found);
    return std::nullopt;
  }
  found->second.used = now;
  return found->second;
}

void Sessions::LogOut(const std::string& id) {
  const std::lock_guard lock(mutex_);
  if (const auto found = sessions_.find(id); found != sessions_.end()) End(found);
}

void Sessions::End(Map::iterator session) {
  *session->second.has_ended = true;
  session->second.feed->board().WakeAll();
  sessions_.erase(session);
}

}  // namespace fovea::observer
