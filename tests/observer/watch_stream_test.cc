#include "client/observer/watch_stream.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/client_interceptor.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

namespace experimental = grpc::experimental;

// Holds the thread of a call where it begins, as a server does that is away.
struct Hold {
  std::promise<void> held, let;
  const std::shared_future<void> is_let = let.get_future().share();
  std::once_flag first;
};

class Holding final : public experimental::Interceptor,
                      public experimental::ClientInterceptorFactoryInterface {
 public:
  explicit Holding(std::shared_ptr<Hold> hold) : hold_(std::move(hold)) {}

  void Intercept(experimental::InterceptorBatchMethods* methods) override {
    using Point = experimental::InterceptionHookPoints;
    if (methods->QueryInterceptionHookPoint(Point::PRE_SEND_INITIAL_METADATA)) {
      std::call_once(hold_->first, [&] { hold_->held.set_value(); });
      hold_->is_let.wait();
    }
    methods->Proceed();
  }
  experimental::Interceptor* CreateClientInterceptor(experimental::ClientRpcInfo*) override {
    return new Holding(hold_);
  }

 private:
  const std::shared_ptr<Hold> hold_;  // which outlives the test, as the thread does
};

TEST(ObserverWatchStream, IsLeftAtOnceWhateverItsThreadWaitsFor) {
  const auto hold = std::make_shared<Hold>();
  std::vector<std::unique_ptr<experimental::ClientInterceptorFactoryInterface>> interceptors;
  interceptors.push_back(std::make_unique<Holding>(hold));
  const observer::ServerLink link{
      .address = "127.0.0.1:1",
      .channel = experimental::CreateCustomChannelWithInterceptors(
          "127.0.0.1:1", grpc::InsecureChannelCredentials(), {}, std::move(interceptors))};
  std::atomic<int> num_told = 0;
  auto stream = std::make_unique<observer::WatchStream>(
      link, "token", v1::WatchRequest(),
      observer::WatchStream::Listener{.on_observer = [&](const v1::Observer&) { ++num_told; },
                                      .on_frame = [&](const v1::WatchResponse&) { ++num_told; },
                                      .on_state = [&](const observer::LinkState&) { ++num_told; }});
  hold->held.get_future().wait();
  auto left = std::async(std::launch::async, [&] { stream.reset(); });
  EXPECT_EQ(left.wait_for(kPatience), std::future_status::ready) << "it waits for its thread";
  hold->let.set_value();
  left.wait();
  EXPECT_EQ(num_told, 0);
}

}  // namespace
}  // namespace fovea::testing
