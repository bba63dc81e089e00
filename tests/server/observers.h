// A server that lets people watch, with two of them.
#pragma once

#include <grpcpp/create_channel.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "client/client.h"
#include "fovea/v1/observation_service.grpc.pb.h"
#include "server/access/token_line.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {

class Observers : public ::testing::Test {
 protected:
  Observers() {
    options_.observers =
        folder_.Write("observers", Line("ann", "all-of-it", "view,try,download,pick", "*") +
                                       Line("ben", "kitchens", "view", "kitchen-*,hall"));
  }

  static std::string Line(const std::string& name, const std::string& token,
                          const std::string& rights, const std::string& robots,
                          const std::string& expires = "") {
    return name + " " + server::HashOfToken(token) + " " + rights + " " + robots + " " + expires +
           "\n";
  }

  static void Detect(const Loopback& loopback, const std::string& robot,
                     const v1::DetectRequest& request = TestRequest()) {
    client::ClientOptions options = PatientOptions();
    options.robot = robot;
    client::Client(loopback.server.Address(), options).Detect(request);
  }

  const TemporaryFolder folder_;
  server::ServerOptions options_ = LoopbackOptions();
};

// Calls `call(stub, context)` with this token.
template <typename Call>
grpc::Status AskAs(const std::string& address, const std::string& token, Call call) {
  const auto stub = v1::ObservationService::NewStub(
      grpc::CreateChannel(address, grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + kPatience);
  context.AddMetadata("authorization", "Bearer " + token);
  return call(*stub, &context);
}

}  // namespace fovea::testing
