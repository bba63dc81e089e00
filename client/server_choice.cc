#include "client/server_choice.h"

#include <algorithm>

namespace fovea::client {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kFirstAway{100}, kLongestAway{5000};
// A move costs a place in line: it has to be worth it, and what servers say is a guess.
constexpr double kMuchSooner = 0.8;
constexpr int kAnswersToMove = 2;

}  // namespace

void ServerChoice::SetServers(const std::vector<std::string>& names) {
  std::vector<Server> servers;
  for (const std::string& name : names) {
    const Server* known = Find(name);
    servers.push_back(known != nullptr ? *known : Server{name});
  }
  const bool same =
      servers.size() == servers_.size() && std::ranges::all_of(servers_, [&](const Server& server) {
        return std::ranges::find(names, server.name) != names.end();
      });
  servers_ = std::move(servers);
  if (!same) home_.clear();
}

const std::string& ServerChoice::Home(Clock::time_point now) {
  if (AreAllAway(now)) {
    home_ = std::ranges::min(servers_, {}, &Server::away_until).name;
  } else if (home_.empty() || IsAway(home_, now)) {
    home_ = Another({}, /*only_there=*/true, now);
    num_elsewhere_ = 0;
  }
  return home_;
}

void ServerChoice::OnAway(const std::string& name, Clock::time_point now,
                          std::optional<milliseconds> duration) {
  Server* server = Find(name);
  if (server == nullptr) return;
  const int doublings = std::min(server->failures++, 10);
  server->away_until =
      now + duration.value_or(std::min(kFirstAway * (1 << doublings), kLongestAway));
}

void ServerChoice::OnDisconnected(const std::string& name) {
  if (home_ == name) home_.clear();
}

void ServerChoice::OnAnswered(const std::string& name) {
  if (Server* server = Find(name)) *server = Server{name};
  if (name == home_) {
    num_elsewhere_ = 0;
  } else if (++num_elsewhere_ >= kAnswersToMove) {
    home_ = name;
    num_elsewhere_ = 0;
  }
}

bool ServerChoice::IsAway(const std::string& name, Clock::time_point now) const {
  const Server* server = Find(name);
  return server == nullptr || server->away_until > now;
}

bool ServerChoice::AreAllAway(Clock::time_point now) const {
  return std::ranges::all_of(servers_, [&](const Server& each) { return each.away_until > now; });
}

const ServerChoice::Server* ServerChoice::Find(const std::string& name) const {
  const auto found = std::ranges::find(servers_, name, &Server::name);
  return found == servers_.end() ? nullptr : &*found;
}

ServerChoice::Server* ServerChoice::Find(const std::string& name) {
  const auto found = std::ranges::find(servers_, name, &Server::name);
  return found == servers_.end() ? nullptr : &*found;
}

std::string ServerChoice::Another(const std::set<std::string>& except, bool only_there,
                                  Clock::time_point now) {
  std::vector<std::string> there, away;
  for (const Server& each : servers_) {
    if (!except.contains(each.name)) (each.away_until > now ? away : there).push_back(each.name);
  }
  const std::vector<std::string>& from = there.empty() && !only_there ? away : there;
  if (from.empty()) return {};
  return from[std::uniform_int_distribution<std::size_t>(0, from.size() - 1)(random_)];
}

std::optional<ServerRound::Ask> ServerRound::Next(Clock::time_point now) {
  if (choice_.size() == 0) return std::nullopt;
  if (!last_) {
    last_ = Ask{choice_.Home(now)};
  } else if (wait_) {
    last_ = has_moved_ || !asks_others_ ? std::nullopt : AskAnother(now);
    if (!last_) return std::nullopt;
  } else {  // the home is away
    const std::string next = choice_.Another(asked_, /*only_there=*/false, now);
    if (next.empty() || has_moved_) return std::nullopt;
    choice_.home_ = next;
    last_ = Ask{next};
  }
  asked_.insert(last_->server);
  return last_;
}

std::optional<ServerRound::Ask> ServerRound::AskAnother(Clock::time_point now) {
  if (num_others_ < kMaxOthers) {
    const std::string next = choice_.Another(asked_, /*only_there=*/true, now);
    if (!next.empty()) {
      ++num_others_;
      return Ask{next, /*in_line_elsewhere=*/true};
    }
  }
  return Move();
}

// Asks for a place in line there.
std::optional<ServerRound::Ask> ServerRound::Move() {
  if (!least_wait_ || *least_wait_ >= *wait_ * kMuchSooner) return std::nullopt;
  has_moved_ = true;
  wait_.reset();
  choice_.home_ = least_;
  return Ask{least_};
}

void ServerRound::OnAnswered() { choice_.OnAnswered(last_->server); }

void ServerRound::OnRefused(milliseconds retry_after) {
  if (!last_->in_line_elsewhere) {
    wait_ = retry_after;
  } else if (!least_wait_ || retry_after < *least_wait_) {
    least_wait_ = retry_after;
    least_ = last_->server;
  }
}

void ServerRound::OnAway(Clock::time_point now) { choice_.OnAway(last_->server, now); }

}  // namespace fovea::client
