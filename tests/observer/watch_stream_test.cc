#include "client/observer/watch_stream.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/generic/async_generic_service.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/client_interceptor.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <string>
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

// Greets every watcher, and sends the first one what is no message.
class SendsNonsenseOnce final : public grpc::CallbackGenericService {
 public:
  SendsNonsenseOnce() {
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
    builder.RegisterCallbackGenericService(this);
    server_ = builder.BuildAndStart();
  }
  ~SendsNonsenseOnce() override { server_->Shutdown(std::chrono::system_clock::now()); }

  observer::ServerLink link() const {
    const std::string address = "127.0.0.1:" + std::to_string(port_);
    return {.address = address,
            .channel = grpc::CreateChannel(address, grpc::InsecureChannelCredentials())};
  }

 private:
  class Call final : public grpc::ServerGenericBidiReactor {
   public:
    explicit Call(bool is_first) : is_first_(is_first) {
      v1::WatchResponse greeting;
      greeting.mutable_observer()->set_name("ann");
      Send(greeting.SerializeAsString());
    }
    void OnWriteDone(bool ok) override {
      if (ok && std::exchange(is_first_, false)) Send("\xFF\xFF");
    }
    void OnCancel() override { Finish(grpc::Status::CANCELLED); }
    void OnDone() override { delete this; }

   private:
    void Send(const std::string& message) {
      const grpc::Slice slice(message);
      bytes_ = grpc::ByteBuffer(&slice, 1);
      StartWrite(&bytes_);
    }

    grpc::ByteBuffer bytes_;
    bool is_first_;
  };

  grpc::ServerGenericBidiReactor* CreateReactor(grpc::GenericCallbackServerContext*) override {
    return new Call(num_calls_++ == 0);
  }

  int port_ = 0;
  std::atomic<int> num_calls_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

TEST(ObserverWatchStream, SaysWhatItCannotReadAndWatchesAgain) {
  const SendsNonsenseOnce server;
  std::promise<void> done;
  std::vector<observer::LinkState> states;  // of the stream's thread, until it is done
  const observer::WatchStream stream(
      server.link(), "token", v1::WatchRequest(),
      observer::WatchStream::Listener{.on_observer = [](const v1::Observer&) {},
                                      .on_frame = [](const v1::WatchResponse&) {},
                                      .on_state =
                                          [&](const observer::LinkState& state) {
                                            states.push_back(state);
                                            if (states.size() == 3) done.set_value();
                                          }});
  ASSERT_EQ(done.get_future().wait_for(kPatience), std::future_status::ready);
  EXPECT_EQ(states[0].kind, observer::LinkState::Kind::kWatching);
  EXPECT_EQ(states[1].kind, observer::LinkState::Kind::kAway);
  EXPECT_EQ(states[1].problem, "the server sent a WatchResponse that cannot be read");
  EXPECT_EQ(states[2].kind, observer::LinkState::Kind::kWatching);
}

}  // namespace
}  // namespace fovea::testing
