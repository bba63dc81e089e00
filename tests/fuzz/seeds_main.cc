// Writes the inputs that fuzzing starts from: one valid one per encoding.
// usage: fovea-fuzz-seeds CORPUS_FOLDER
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "client/bundle/bundle.h"
#include "client/images.h"
#include "client/rvl.h"
#include "tests/server/frames.h"
#include "tests/support/bag_writer.h"

namespace {

using namespace fovea::testing;  // NOLINT(google-build-using-namespace)
namespace fs = std::filesystem;

void Write(const fs::path& folder, const std::string& name, const std::string& bytes) {
  fs::create_directories(folder);
  std::ofstream(folder / name, std::ios::binary) << bytes;
}

void WriteRequests(const fs::path& folder) {
  Write(folder, "raw", TestRequest().SerializeAsString());
  fovea::v1::DetectRequest request = TestRequest();
  *request.mutable_frame()->mutable_color() =
      ColorMessage(fovea::v1::COLOR_ENCODING_JPEG, JpegOf(TestColor()));
  *request.mutable_frame()->mutable_depth() = DepthMessage(
      fovea::v1::DEPTH_ENCODING_16UC1_ZSTD, ZstdOf(BytesOf(TestDepth())), kWidth, kHeight);
  request.mutable_frame()->mutable_gravity()->set_y(1);
  request.mutable_frame()->mutable_camera_pose()->mutable_orientation()->set_w(1);
  (*request.mutable_options()->mutable_parameters())["max_depth_m"] = 5;
  Write(folder, "compressed", request.SerializeAsString());
  request = TestRequest();
  *request.mutable_frame()->mutable_depth_intrinsics() = request.frame().intrinsics();
  request.mutable_frame()->mutable_color_from_depth()->mutable_position()->set_x(0.025);
  request.mutable_frame()->mutable_color_from_depth()->mutable_orientation()->set_w(1);
  *request.mutable_frame()->mutable_depth() = DepthMessage(
      fovea::v1::DEPTH_ENCODING_16UC1_RVL_ZSTD, ZstdOf(RvlOf(TestDepth())), kWidth, kHeight);
  Write(folder, "unregistered", request.SerializeAsString());
  *request.mutable_frame()->mutable_intrinsics()->mutable_distortion() =
      fovea::client::MakeLensDistortion("plumb_bob", {-0.1, 0.02, 0.001, 0.002, 0});
  *request.mutable_frame()->mutable_depth_intrinsics()->mutable_distortion() =
      fovea::client::MakeLensDistortion("equidistant", {-0.01, 0.03, 0, 0});
  Write(folder, "distorted", request.SerializeAsString());
  request = TestRequest();
  fovea::v1::DetectOptions& options = *request.mutable_options();
  options.mutable_grasps()->add_grippers()->mutable_jaw()->mutable_palm_size()->set_x(0.1);
  options.mutable_grasps()->add_grippers()->mutable_suction()->set_max_curvature_per_m(10);
  options.mutable_grasps()->mutable_grippers(0)->mutable_approach()->set_z(1);
  options.mutable_places()->mutable_size()->set_x(0.1);
  options.mutable_places()->set_margin_m(0.05);
  options.mutable_planning()->set_collision_primitives(true);
  options.mutable_planning()->mutable_height_map()->set_cell_m(0.01);
  options.mutable_planning()->mutable_height_map()->set_max_cells(1000);
  Write(folder, "robot", request.SerializeAsString());
}

void WriteBags(const fs::path& folder) {
  constexpr std::int64_t kTime_ns = 1'700'000'000'000'000'000;
  for (const std::string compression : {"", "zstd", "lz4"}) {
    BagWriter writer;
    writer.Add("/color/camera_info", "CameraInfo", CameraInfoMessage(4, 2, 5, 0.1));
    writer.Add("/color/image", "Image",
               ImageMessage(kTime_ns, "rgb8", 4, 2, 12, std::string(24, 'c')));
    writer.Add("/depth/image", "Image",
               ImageMessage(kTime_ns, "16UC1", 4, 2, 8, std::string(16, 'd')));
    writer.EndChunk(compression);
    writer.Add("/color/image", "CompressedImage",
               CompressedMessage(2 * kTime_ns, "jpeg", "\xff\xd8\xff"));
    writer.Add("/depth/image", "CompressedImage",
               CompressedMessage(2 * kTime_ns, "16UC1; compressedDepth png", std::string(20, 'p')));
    writer.Add("/depth/image", "Image", ImageMessage(kTime_ns, "32FC1", 1, 1, 4, "abcd"));
    writer.Add("/color/image", "Image", ImageMessage(kTime_ns / 2, "mono8", 1, 1, 1, "c"));
    writer.Add("/depth/image", "CompressedImage",
               CompressedMessage(kTime_ns / 2, "32FC1; compressedDepth png",
                                 std::string(12, '>') + PngOf(TestDepth())));
    Write(folder, compression.empty() ? "plain" : compression, writer.Finish());
  }
}

// Encodings of colour, in messages that were compressed one by one, with depth in RVL.
void WriteEncodings(const fs::path& folder) {
  constexpr std::int64_t kTime_ns = 1'700'000'000'000'000'000;
  BagWriter writer;
  std::int64_t time_ns = kTime_ns;
  bool is_in_meters = false;
  for (const char* encoding : {"bgra8", "uyvy", "yuv422_yuy2", "bayer_rggb8", "bayer_gbrg8"}) {
    time_ns += 1'000'000'000;
    const std::string image = ImageMessage(time_ns, encoding, 4, 4, 16, std::string(64, 'c'));
    writer.Add("/color/image", "Image", ZstdOf(image));
    const std::string size("\x04\0\0\0\x04\0\0\0", 8);
    const std::string rvl =
        fovea::client::EncodeRvl(std::array<std::uint16_t, 16>{1, 2}.data(), 16);
    const std::string depth = std::string(12, '\1') + size + rvl;
    const std::string format =
        std::string(is_in_meters ? "32FC1" : "16UC1") + "; compressedDepth rvl";
    writer.Add("/depth/image", "CompressedImage", CompressedMessage(time_ns, format, depth));
    is_in_meters = !is_in_meters;
  }
  Write(folder, "encodings", writer.Finish());
}

void WriteBundles(const fs::path& folder) {
  fovea::bundle::BundledFrame frame{.request = TestRequest(), .answer = fovea::v1::Detections()};
  frame.answer->add_objects()->set_label(1);
  Write(folder, "answered", fovea::bundle::WriteBundle({frame}, {.made_by = "seeds"}));
  frame.answer.reset();
  frame.error = fovea::v1::FrameError();
  *frame.request.mutable_frame()->mutable_depth() = DepthMessage(
      fovea::v1::DEPTH_ENCODING_16UC1_RVL_ZSTD, ZstdOf(RvlOf(TestDepth())), kWidth, kHeight);
  Write(folder, "refused", fovea::bundle::WriteBundle({frame}, {.made_by = "seeds"}));
}

// As routes_fuzzer.cc reads them.
void WriteHttpRequests(const fs::path& folder) {
  const std::string own = "host: localhost\norigin: http://localhost\n";
  const std::string cookie = "cookie: a=b; fovea_session=0123\nx-fovea-csrf: 0123\n";
  const auto get = [&](const std::string& name, const std::string& target) {
    Write(folder, name, "GET " + target + " HTTP/1.1\n" + own + cookie + "\n");
  };
  const auto post = [&](const std::string& name, const std::string& path, const std::string& body) {
    Write(folder, name, "POST " + path + " HTTP/1.1\n" + own + cookie + "\n" + body);
  };
  get("page", "/index.html");
  get("events", "/api/events?close=kitchen%2D1&depth=1");
  get("history", "/api/history?robot=kitchen-1");
  for (const std::string part : {"answer", "picture", "depth"}) {
    get("past_" + part, "/api/history/" + part + "?robot=kitchen-1&id=1700000000000000");
  }
  get("bundle", "/api/history/bundle?robot=kitchen-1&at=1700000000000000&before=5&after=5");
  get("foreign", "/api/history/bundle?robot=attic&at=1700000000000000");
  get("options", "/api/options?robot=kitchen-1&id=1700000000000000");
  post("login", "/api/login", R"({"token": "token"})");
  post("try", "/api/try",
       R"({"robot":"kitchen-1","id":1700000000000000,"options":{"parameters":{"a":1}}})");
  post("pick", "/api/pick", R"({"robot":"kitchen-1","id":1,"past":false,"label":1})");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fovea-fuzz-seeds CORPUS_FOLDER\n";
    return 1;
  }
  const fs::path corpus = argv[1];
  Write(corpus / "jpeg", "color", JpegOf(TestColor()));
  Write(corpus / "png", "color", PngOf(TestColor()));
  Write(corpus / "png", "depth", PngOf(TestDepth()));
  const std::string wanted{static_cast<char>(kDepthBytes & 0xFF),
                           static_cast<char>(kDepthBytes >> 8)};
  Write(corpus / "zstd", "depth", wanted + ZstdOf(BytesOf(TestDepth())));
  Write(corpus / "rvl", "depth", RvlOf(TestDepth()));
  WriteRequests(corpus / "request");
  WriteBags(corpus / "mcap");
  WriteEncodings(corpus / "mcap");
  WriteBundles(corpus / "bundle");
  WriteHttpRequests(corpus / "routes");
  return 0;
}
