// The shortest useful client: two image files in, positions and grasps out.
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

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
  fovea::v1::DetectRequest request;
  *request.mutable_frame()->mutable_color() = fovea::client::MakeColorImage(ReadFile(argv[2]));
  *request.mutable_frame()->mutable_depth() = fovea::client::MakeDepthImage(ReadFile(argv[3]));
  *request.mutable_frame()->mutable_intrinsics() =
      fovea::client::MakeIntrinsics(525, 525, 319.5, 239.5);

  const fovea::v1::DetectResponse response = client.Detect(request);
  for (const auto& object : response.detections().objects()) {
    const auto& at = object.oriented_box().pose().position();
    std::cout << object.label() << ": " << at.x() << ' ' << at.y() << ' ' << at.z() << " m, "
              << object.grasps_size() << " grasps\n";
  }
} catch (const std::exception& error) {
  std::cerr << "detect_once: " << error.what() << '\n';
  return 1;
}
