// Calls that wait for one another in a server: one holds its compute thread, many stand in its
// queue.
#pragma once

#include <grpcpp/create_channel.h>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"

namespace fovea::testing {

inline void AwaitWaiting(const Loopback& loopback, double count) {
  AwaitMetric(*loopback.server.metrics(), "fovea_frames_waiting", count);
}

// A call by a robot of this name, with all that gRPC says of it.
struct Call {
  Call(const Loopback& loopback, const std::string& robot)
      : stub(v1::DetectionService::NewStub(
            grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials()))) {
    context.AddMetadata("fovea-robot", robot);
    context.set_deadline(std::chrono::system_clock::now() + kPatience);
  }

  grpc::Status Run(const v1::DetectRequest& request = TestRequest()) {
    return stub->Detect(&context, request, &response);
  }

  std::string Trailer(const std::string& key) const {
    const auto found = context.GetServerTrailingMetadata().find(key);
    if (found == context.GetServerTrailingMetadata().end()) return "";
    return {found->second.data(), found->second.size()};
  }

  std::unique_ptr<v1::DetectionService::Stub> stub;
  grpc::ClientContext context;
  v1::DetectResponse response;
};

// Calls of many robots that wait for one another in a known order.
class Crowd {
 public:
  explicit Crowd(Loopback& loopback) : loopback_(loopback) {}

  // Returns once the call waits in the server's queue, or has ended where it should not.
  void Join(const std::string& robot, const v1::DetectRequest& request = TestRequest()) {
    calls_.push_back(std::make_unique<Call>(loopback_, robot));
    threads_.emplace_back([this, robot, request, call = calls_.back().get()] {
      const bool ok = call->Run(request).ok();
      const std::lock_guard lock(mutex_);
      answered_.push_back(ok ? robot : "no " + robot);
    });
    while (NumWaiting() + NumAnswered() < calls_.size()) std::this_thread::yield();
  }

  void LeaveLast() { calls_.back()->context.TryCancel(); }

  std::vector<std::string> Answered() {
    threads_.clear();  // joins
    return answered_;
  }

 private:
  std::size_t NumWaiting() const {
    return static_cast<std::size_t>(
        MetricValue(*loopback_.server.metrics(), "fovea_frames_waiting"));
  }
  std::size_t NumAnswered() {
    const std::lock_guard lock(mutex_);
    return answered_.size();
  }

  Loopback& loopback_;
  std::vector<std::unique_ptr<Call>> calls_;
  std::mutex mutex_;
  std::vector<std::string> answered_;
  std::vector<std::jthread> threads_;
};

// Holds the compute thread with a first call until the test lets it go.
struct Held {
  explicit Held(const server::ServerOptions& options) : loopback(std::ref(gate), options) {
    first = std::async(std::launch::async, [&] { return Call(loopback, "first").Run(); });
    gate.WaitUntilBegun();
  }
  ~Held() { gate.Let(100); }

  Gate gate;
  Loopback loopback;
  std::future<grpc::Status> first;
};

}  // namespace fovea::testing
