// A real server on a free loopback port, with a client.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>

#include "client/client.h"
#include "server/server.h"
#include "tests/server/frames.h"

namespace fovea::testing {

// Long enough that only a hang reaches it.
constexpr std::chrono::minutes kPatience{1};

// A free port of this machine.
server::ServerOptions LoopbackOptions();

// Calls are made once, so that tests see what the server says to them.
inline client::ClientOptions PatientOptions() {
  client::ClientOptions options{.timeout = kPatience};
  options.retry.max_attempts = 1;
  return options;
}

struct Loopback {
  explicit Loopback(server::DetectFunction detect = fovea::Detect,
                    const server::ServerOptions& options = LoopbackOptions())
      : server(options, std::move(detect)), client(server.Address(), PatientOptions()) {}

  server::Server server;
  client::Client client;
};

// A stream of this client that has had an answer. Throws RpcError where the server ends it instead.
inline std::unique_ptr<client::DetectStream> AnsweredStream(const client::Client& client) {
  auto stream = client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  stream->Send(request);
  EXPECT_TRUE(stream->Receive());
  return stream;
}

// Of a call of this client, OK where it is answered.
inline grpc::Status StatusOfDetecting(const client::Client& client) {
  try {
    client.Detect(TestRequest());
    return grpc::Status::OK;
  } catch (const client::RpcError& error) {
    return {error.code(), error.message()};
  }
}

// Runs `call`, which must throw RpcError, and returns that as a status.
template <typename Call>
grpc::Status StatusOf(Call&& call) {
  try {
    call();
  } catch (const client::RpcError& error) {
    return {error.code(), error.message()};
  }
  ADD_FAILURE() << "the call succeeded";
  return grpc::Status::OK;
}

}  // namespace fovea::testing
