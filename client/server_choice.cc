#include "client/server_choice.h"

#include <algorithm>

namespace fovea::client {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kFirstAway{100}, kLongestAway{5000};
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
    last_ = AskHome(choice_.Home(now), now);
  } else if (wait_ || (least_wait_ && !last_->only_if_room)) {
    return std::nullopt;
  } else if (least_wait_) {
    last_ = AskAnother(now);
  } else {  // the home is away
    const std::string next = choice_.Another(asked_, /*only_there=*/false, now);
    if (next.empty()) return std::nullopt;
    last_ = AskHome(next, now);
  }
  asked_.insert(last_->server);
  return last_;
}

// For a place in line at once where there is nobody else to ask.
ServerRound::Ask ServerRound::AskHome(const std::string& home, Clock::time_point now) {
  choice_.home_ = home;
  std::set<std::string> asked = asked_;
  asked.insert(home);
  const bool has_others = !choice_.Another(asked, /*only_there=*/true, now).empty();
  return {home, /*only_if_room=*/asks_others_ && has_others && !choice_.has_asked_others_};
}

// For room; once nobody is left, whoever said the least for a place.
ServerRound::Ask ServerRound::AskAnother(Clock::time_point now) {
  if (num_others_++ < kMaxOthers) {
    const std::string next = choice_.Another(asked_, /*only_there=*/true, now);
    if (!next.empty()) return {next, /*only_if_room=*/true};
  }
  choice_.home_ = least_;
  return {least_};
}

void ServerRound::OnAnswered() { choice_.OnAnswered(last_->server); }

void ServerRound::OnRefused(milliseconds retry_after) {
  if (!last_->only_if_room) {
    wait_ = retry_after;
    if (asks_others_) choice_.has_asked_others_ = least_wait_.has_value();
  } else if (!least_wait_ || retry_after < *least_wait_) {
    least_wait_ = retry_after;
    least_ = last_->server;
  }
}

void ServerRound::OnAway(Clock::time_point now) { choice_.OnAway(last_->server, now); }

}  // namespace fovea::client
