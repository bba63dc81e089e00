#include "tests/server/loopback.h"

#include <spdlog/spdlog.h>

#include "tests/server/frames.h"

namespace fovea::testing {

server::ServerOptions LoopbackOptions() {
  spdlog::default_logger();  // made before any thread of a server starts, as in its main
  server::ServerOptions options;
  options.listen = {"127.0.0.1:0"};
  return options;
}

std::unique_ptr<client::DetectStream> AnsweredStream(const client::Client& client) {
  auto stream = client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  stream->Send(request);
  EXPECT_TRUE(stream->Receive());
  return stream;
}

}  // namespace fovea::testing
