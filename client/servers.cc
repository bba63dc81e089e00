#include "client/servers.h"

#include <random>
#include <utility>

#include "client/channel.h"

namespace fovea::client {

Servers::Servers(const std::string& address, ClientOptions options)
    : options_(std::move(options)),
      lookup_(ParseServerAddresses(address)),
      choice_(std::random_device{}()) {}

std::vector<Servers::Pointer> Servers::All(Clock::time_point deadline, std::string* problem) {
  FoundTargets found = lookup_.Get(deadline);
  *problem = std::move(found.problem);
  return Take(found.targets);
}

std::vector<Servers::Pointer> Servers::Take(const std::vector<ServerTarget>& targets) {
  const std::lock_guard lock(mutex_);
  if (targets.empty()) return AllKnown();  // another thread may have found some meanwhile
  std::map<std::string, Pointer> servers;
  std::vector<std::string> names;
  std::vector<Pointer> all;
  for (const ServerTarget& each : targets) {
    Pointer server = Find(each.target);
    if (!server) {
      server = std::make_shared<Server>(
          Server{each.target, MakeChannel(each, targets.size() > 1, options_), nullptr});
      server->stub = v1::DetectionService::NewStub(server->channel);
    }
    servers.emplace(each.target, server);
    names.push_back(each.target);
    all.push_back(std::move(server));
  }
  servers_ = std::move(servers);
  choice_.SetServers(names);
  return all;
}

Servers::Pointer Servers::Home(Clock::time_point deadline, std::string* problem) {
  if (All(deadline, problem).empty()) return nullptr;
  const std::lock_guard lock(mutex_);
  Pointer home = Find(choice_.Home(Clock::now()));
  const bool connected = home->channel->GetState(false) == GRPC_CHANNEL_READY;
  // A server that has had a connection for long enough ends it, so that another one gets a chance.
  if (!connected && connected_ == home->name) {
    choice_.OnDisconnected(home->name);
    lookup_.Refresh();
    home = Find(choice_.Home(Clock::now()));
  }
  connected_ = home->channel->GetState(false) == GRPC_CHANNEL_READY ? home->name : "";
  return home;
}

void Servers::OnAway(const Pointer& server, std::optional<std::chrono::milliseconds> duration) {
  lookup_.Refresh();
  const std::lock_guard lock(mutex_);
  choice_.OnAway(server->name, Clock::now(), duration);
}

void Servers::OnDisconnected(const Pointer& server) {
  lookup_.Refresh();
  const std::lock_guard lock(mutex_);
  choice_.OnDisconnected(server->name);
}

void Servers::Move(const Pointer& server) {
  const std::lock_guard lock(mutex_);
  choice_.Move(server->name);
}

void Servers::OnAnswered(const Pointer& server) {
  const std::lock_guard lock(mutex_);
  choice_.OnAnswered(server->name);
}

bool Servers::AreAllAway() {
  const std::lock_guard lock(mutex_);
  return choice_.AreAllAway(Clock::now());
}

std::size_t Servers::size() {
  const std::lock_guard lock(mutex_);
  return choice_.size();
}

std::vector<Servers::Pointer> Servers::AllKnown() {
  std::vector<Pointer> all;
  for (const auto& [name, server] : servers_) all.push_back(server);
  return all;
}

Servers::Pointer Servers::Find(const std::string& name) {
  const auto found = servers_.find(name);
  return found == servers_.end() ? nullptr : found->second;
}

Servers::Round::Round(Servers& servers, bool asks_others, Clock::time_point deadline)
    : servers_(servers),
      round_(servers.choice_, asks_others),
      home_(servers.Home(deadline, &problem_)) {}

std::optional<Servers::Round::Ask> Servers::Round::Next() {
  if (!home_) return std::nullopt;
  const std::lock_guard lock(servers_.mutex_);
  while (auto next = round_.Next(Clock::now())) {
    Pointer server = servers_.Find(next->server);
    if (!server) {  // no longer one of them, by another thread's lookup
      round_.OnAway(Clock::now());
      continue;
    }
    if (!next->only_if_room) home_ = server;
    return Ask{std::move(server), next->only_if_room};
  }
  return std::nullopt;
}

void Servers::Round::OnAnswered() {
  const std::lock_guard lock(servers_.mutex_);
  round_.OnAnswered();
}

void Servers::Round::OnRefused(std::chrono::milliseconds retry_after) {
  servers_.lookup_.Refresh();
  const std::lock_guard lock(servers_.mutex_);
  round_.OnRefused(retry_after);
}

void Servers::Round::OnAway() {
  servers_.lookup_.Refresh();
  const std::lock_guard lock(servers_.mutex_);
  round_.OnAway(Clock::now());
}

std::optional<std::chrono::milliseconds> Servers::Round::wait() {
  const std::lock_guard lock(servers_.mutex_);
  return round_.wait();
}

}  // namespace fovea::client
