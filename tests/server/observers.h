// A server that lets people watch, with two of them.
#pragma once

#include <grpcpp/create_channel.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

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

// One call of Watch.
class Watching {
 public:
  Watching(const std::string& address, const std::string& token,
           const v1::WatchRequest& request = {})
      : stub_(v1::ObservationService::NewStub(
            grpc::CreateChannel(address, grpc::InsecureChannelCredentials()))) {
    context_.set_deadline(std::chrono::system_clock::now() + kPatience);
    if (!token.empty()) context_.AddMetadata("authorization", "Bearer " + token);
    reader_ = stub_->Watch(&context_, request);
  }
  ~Watching() { context_.TryCancel(); }

  // The next message; an empty one at the end.
  v1::WatchResponse Next() {
    v1::WatchResponse response;
    if (!reader_->Read(&response)) return {};
    return response;
  }
  grpc::Status Finish() {
    while (reader_->Read(&ignored_)) {
    }
    return reader_->Finish();
  }

 private:
  std::unique_ptr<v1::ObservationService::Stub> stub_;
  grpc::ClientContext context_;
  std::unique_ptr<grpc::ClientReader<v1::WatchResponse>> reader_;
  v1::WatchResponse ignored_;
};

inline v1::WatchRequest RequestOf(const std::vector<v1::WatchPart>& parts, double rate_hz = 30) {
  v1::WatchRequest request;
  request.set_max_rate_hz(rate_hz);
  for (const v1::WatchPart part : parts) request.add_parts(part);
  return request;
}

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
