#pragma once

#include <grpcpp/server.h>

#include <memory>
#include <string>

#include "server/detection_service.h"
#include "server/server_options.h"

namespace fovea::server {

// A running gRPC server: fovea.v1.DetectionService, grpc.health.v1.Health and reflection.
class Server {
 public:
  // Listens and serves when this returns. Throws std::invalid_argument for options that do not
  // validate, std::runtime_error where the address cannot be listened on.
  explicit Server(const ServerOptions& options, DetectFunction detect = fovea::Detect);

  // Like Drain() without patience.
  ~Server();

  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // HOST:PORT with the real port where 0 was asked for.
  std::string Address() const;

  // Reports NOT_SERVING, takes no more calls, lets those under way finish until the drain timeout
  // and cancels what is left. Returns when all are gone.
  void Drain();

 private:
  void Stop(int timeout_s);

  const ServerOptions options_;
  DetectionService service_;
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace fovea::server
