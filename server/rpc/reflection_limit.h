#pragma once

#include <grpcpp/support/server_interceptor.h>

#include <memory>

namespace fovea::server {

// Bounds how many calls of gRPC's reflection are open: each holds a thread as long as its caller
// likes, and needs no token. Those beyond are cancelled.
std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface> MakeReflectionLimit();

}  // namespace fovea::server
