// A robot's camera loop: frames go out as they come, answers come in beside them. The same frame is
// sent again and again here, in place of a camera.
#include <chrono>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

#include "fovea/client/client.h"
#include "fovea/client/images.h"

std::string ReadFile(const char* path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(std::string("cannot read ") + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

int main(int argc, char** argv) try {
  if (argc != 4) throw std::invalid_argument("give HOST:PORT, a colour image and a depth PNG");
  const fovea::client::Client client(argv[1]);
  client.WaitUntilReady(std::chrono::seconds(10));

  fovea::v1::DetectStreamRequest request;
  *request.mutable_frame()->mutable_color() = fovea::client::MakeColorImage(ReadFile(argv[2]));
  *request.mutable_frame()->mutable_depth() = fovea::client::MakeDepthImage(ReadFile(argv[3]));
  *request.mutable_frame()->mutable_intrinsics() =
      fovea::client::MakeIntrinsics(525, 525, 319.5, 239.5);

  // Connects again when the server was away; the server answers the newest frame.
  const auto stream = client.OpenResumingStream(std::chrono::hours(1));
  std::jthread camera([&] {
    for (int i = 0; i < 30; ++i) {
      request.mutable_frame()->set_id("frame " + std::to_string(i));
      stream->Send(request);
      std::this_thread::sleep_for(std::chrono::milliseconds(33));
    }
    stream->DoneSending();
  });
  while (const auto answer = stream->Receive()) {
    const fovea::v1::DetectStreamResponse& response = answer->response;
    std::cout << response.frame_id() << ": ";
    if (response.has_error()) {
      std::cout << response.error().message() << '\n';
    } else {
      const int found = response.detections().objects_size();
      std::cout << found << (found == 1 ? " object, " : " objects, ") << response.dropped()
                << " frames dropped before it, " << answer->lost << " lost\n";
    }
  }
} catch (const std::exception& error) {
  std::cerr << "detect_stream: " << error.what() << '\n';
  return 1;
}
