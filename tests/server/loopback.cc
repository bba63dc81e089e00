#include "tests/server/loopback.h"

#include <spdlog/spdlog.h>

namespace fovea::testing {

server::ServerOptions LoopbackOptions() {
  spdlog::default_logger();  // made before any thread of a server starts, as in its main
  server::ServerOptions options;
  options.listen = {"127.0.0.1:0"};
  return options;
}

}  // namespace fovea::testing
