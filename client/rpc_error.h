#pragma once

#include <grpcpp/support/status.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>

namespace fovea::client {

// A call that did not succeed. what() is "CODE: message", for example
// "INVALID_ARGUMENT: frame.depth.data: has 10 bytes, 640x480 16UC1 needs 614400 (request 17)".
class RpcError : public std::runtime_error {
 public:
  explicit RpcError(const grpc::Status& status,
                    std::optional<std::chrono::milliseconds> retry_after = std::nullopt,
                    std::string request_id = {});

  grpc::StatusCode code() const { return code_; }
  // Without the code's name and the request's.
  const std::string& message() const { return message_; }
  // The field of the request that INVALID_ARGUMENT is about, for example "frame.depth.data"; empty
  // where the server named none.
  const std::string& field() const { return field_; }
  // When a server with too much to do says to come back.
  std::optional<std::chrono::milliseconds> retry_after() const { return retry_after_; }
  // What the log of the server calls the request, if it came there; empty where the server says
  // nothing and CallOptions names none.
  const std::string& request_id() const { return request_id_; }

 private:
  grpc::StatusCode code_;
  std::string message_, field_;
  std::optional<std::chrono::milliseconds> retry_after_;
  std::string request_id_;
};

}  // namespace fovea::client
