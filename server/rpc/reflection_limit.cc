#include "server/rpc/reflection_limit.h"

#include <grpcpp/server_context.h>

#include <atomic>
#include <string_view>

namespace fovea::server {
namespace {

using grpc::experimental::InterceptionHookPoints;
using grpc::experimental::Interceptor;
using grpc::experimental::InterceptorBatchMethods;
using grpc::experimental::ServerRpcInfo;

constexpr int kMaxOpen = 16;

class ReflectionCall : public Interceptor {
 public:
  ReflectionCall(std::atomic<int>& open, ServerRpcInfo* info)
      : open_(open), info_(info), is_beyond_(open_.fetch_add(1) >= kMaxOpen) {}
  ~ReflectionCall() override { --open_; }

  void Intercept(InterceptorBatchMethods* methods) override {
    if (is_beyond_ &&
        methods->QueryInterceptionHookPoint(InterceptionHookPoints::POST_RECV_INITIAL_METADATA)) {
      info_->server_context()->TryCancel();
    }
    methods->Proceed();
  }

 private:
  std::atomic<int>& open_;
  ServerRpcInfo* const info_;
  const bool is_beyond_;
};

class ReflectionLimit : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  Interceptor* CreateServerInterceptor(ServerRpcInfo* info) override {
    const bool reflects = std::string_view(info->method()).starts_with("/grpc.reflection.");
    return reflects ? new ReflectionCall(open_, info) : nullptr;
  }

 private:
  std::atomic<int> open_ = 0;
};

}  // namespace

std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface> MakeReflectionLimit() {
  return std::make_unique<ReflectionLimit>();
}

}  // namespace fovea::server
