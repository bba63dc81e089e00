// A server that is asked about a whole folder: it may start late, be busy or go away meanwhile.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "client/client.h"

namespace fovea::cli {

// It takes calls and answers none: it was stopped, or its machine is overloaded.
struct ServerHangs : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Many threads may ask at once.
class PatientServer {
 public:
  using Explain = std::function<std::string(const client::RpcError&)>;  // words what failed

  // `timeout`: of one answer with all attempts, and of a server that is awaited.
  PatientServer(const client::Client& client, std::chrono::milliseconds timeout, Explain explain)
      : client_(client), timeout_(timeout), explain_(std::move(explain)) {}

  // A server that is being started is waited for; one that is not there is one error and not one a
  // frame. Throws std::runtime_error.
  void Await();
  // How many frames to have in flight: as many as are wanted, else four, or as many as the server
  // takes of one robot; more would be refused, counted there and sent once more.
  std::size_t MostAtOnce(std::optional<int> wanted) const;
  // Comes again where a server takes fewer frames of one caller, or starts anew. Throws
  // client::RpcError: at once where a frame before has waited for the server in vain; ServerHangs
  // where several in turn have, and it does not even say whether it serves.
  v1::DetectResponse Ask(const v1::DetectRequest& request);

  std::string Words(const client::RpcError& error) const { return explain_(error); }

 private:
  std::optional<std::chrono::milliseconds> PauseAfter(const client::RpcError& error) const;
  void CountSilence(const client::RpcError& error);
  void RequireServer() const;
  void RequireLife();

  const client::Client& client_;
  const std::chrono::milliseconds timeout_;
  const Explain explain_;
  // Whether the server answered the last call that ended: then it is likely to come back.
  std::atomic<bool> is_there_{false};
  std::atomic<int> num_unanswered_{0};  // calls in turn whose time passed without any answer
};

}  // namespace fovea::cli
