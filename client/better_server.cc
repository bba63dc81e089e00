#include "client/better_server.h"

#include <algorithm>
#include <optional>

#include "client/channel.h"

namespace fovea::client {
namespace {

using std::chrono::milliseconds;

// What servers say is of some moments: a move has to be worth it.
constexpr double kMuchSooner = 0.85;
// However many there are.
constexpr std::size_t kMaxOthers = 3;

}  // namespace

BetterServer::BetterServer(Servers& servers, const ClientOptions& options, milliseconds shortest,
                           milliseconds timeout)
    : servers_(servers),
      options_(options),
      shortest_(shortest),
      timeout_(timeout),
      random_(std::random_device{}()) {
  PlanNext();
}

Servers::Pointer BetterServer::Find(const Servers::Pointer& own) {
  const auto now = Servers::Clock::now();
  if (now < next_ || servers_.size() < 2) return nullptr;
  PlanNext();
  if (!Ask(*own) || !loads_[own->name].is_overloaded()) return nullptr;
  const std::optional<double> own_turn = loads_[own->name].Turn(/*more=*/0);

  std::string problem;
  auto others = servers_.All(now, &problem);
  std::erase(others, own);
  std::ranges::shuffle(others, random_);
  if (others.size() > kMaxOthers) others.resize(kMaxOthers);
  Servers::Pointer best;
  double least = own_turn.value_or(0) * kMuchSooner;
  for (const Servers::Pointer& other : others) {
    if (!Ask(*other)) continue;
    const std::optional<double> turn = loads_[other->name].Turn(/*more=*/1);
    if (!turn || *turn >= least) continue;
    least = *turn;
    best = other;
  }
  return best;
}

// By chance, so that not all streams of a server leave it at once.
void BetterServer::PlanNext() {
  std::uniform_int_distribution<milliseconds::rep> wait(shortest_.count(),
                                                        shortest_.count() * 7 / 3);
  next_ = Servers::Clock::now() + milliseconds(wait(random_));
}

bool BetterServer::Ask(const Server& server) {
  grpc::ClientContext context;
  PrepareCall(options_, timeout_, &context);
  v1::GetStatisticsResponse statistics;
  if (!server.stub->GetStatistics(&context, {}, &statistics).ok()) return false;
  loads_[server.name].Note(statistics);
  return true;
}

}  // namespace fovea::client
