#pragma once

#include <grpcpp/channel.h>

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "client/client_options.h"
#include "client/name_lookup.h"
#include "client/server_choice.h"
#include "fovea/v1/detection_service.grpc.pb.h"

namespace fovea::client {

struct Server {
  std::string name;  // the target
  std::shared_ptr<grpc::Channel> channel;
  std::unique_ptr<v1::DetectionService::Stub> stub;
};

// The servers that a client's address stands for, a channel to each, and the choice between them.
// Thread-safe.
class Servers {
 public:
  using Clock = ServerChoice::Clock;
  using Pointer = std::shared_ptr<Server>;

  // Throws std::invalid_argument for an address that is none.
  Servers(const std::string& address, ClientOptions options);

  // All of them, as far as names are looked up: waits where nothing is known. Where none is found,
  // `problem` says why.
  std::vector<Pointer> All(Clock::time_point deadline, std::string* problem);

  // What a lookup has found, to choose from from now on; where that is none, those known stay.
  // Returns all of them.
  std::vector<Pointer> Take(const std::vector<ServerTarget>& targets);

  // The one to ask first; null and the problem where none is found.
  Pointer Home(Clock::time_point deadline, std::string* problem);

  void OnAway(const Pointer& server,
              std::optional<std::chrono::milliseconds> duration = std::nullopt);
  void OnDisconnected(const Pointer& server);
  // It is the one to ask first from now on.
  void Move(const Pointer& server);
  void OnAnswered(const Pointer& server);
  bool AreAllAway();
  std::size_t size();

  // One call's way around, see ServerRound.
  class Round {
   public:
    struct Ask {
      Pointer server;
      bool only_if_room = false;
    };

    Round(Servers& servers, bool asks_others, Clock::time_point deadline);

    std::optional<Ask> Next();
    void OnAnswered();
    void OnRefused(std::chrono::milliseconds retry_after);
    void OnAway();

    std::optional<std::chrono::milliseconds> wait();
    // Whom to wait for; null where no server was found, and why.
    const Pointer& home() const { return home_; }
    const std::string& problem() const { return problem_; }

   private:
    Servers& servers_;
    ServerRound round_;
    std::string problem_;
    Pointer home_;  // fills in the problem
  };

 private:
  Pointer Find(const std::string& name);  // mutex_ is held
  std::vector<Pointer> AllKnown();        // mutex_ is held

  const ClientOptions options_;
  NameLookup lookup_;
  std::mutex mutex_;
  ServerChoice choice_;
  std::map<std::string, Pointer> servers_;
  std::string connected_;  // the home whose connection was there when it was last looked at
};

}  // namespace fovea::client
