#include "client/cli/bag/bag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <opencv2/core.hpp>

#include "client/cli/bag/topics.h"
#include "client/image_files/image_files.h"
#include "tests/client/cli/bag/small_bags.h"
#include "tests/support/bag_writer.h"

namespace fovea::cli::small_bags {
namespace {

using testing::BagWriter;
using testing::CameraInfoMessage;
using testing::CompressedMessage;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ImageMessage;

std::string Meters(float first, float second) {
  std::string bytes(8, '\0');
  std::memcpy(bytes.data(), &first, sizeof first);
  std::memcpy(bytes.data() + 4, &second, sizeof second);
  return bytes;
}

TEST(Bag, HasFramesOfWhatWasTakenTogether) {
  for (const char* compression : {"", "zstd", "lz4"}) {
    BagWriter writer;
    writer.Add("/camera/color/camera_info", "CameraInfo", CameraInfoMessage(2, 1, 525, -0.25));
    writer.Add("/camera/depth/camera_info", "CameraInfo", CameraInfoMessage(2, 1, 400));
    writer.Add("/chatter", "String", "anything");
    writer.Add(kColor, "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 8, kRgb + "  "));
    writer.Add(kDepth, "Image",
               ImageMessage(kFirst_ns + kMillisecond_ns, "16UC1", 2, 1, 4, kUnits));
    writer.EndChunk(compression);
    writer.Add(kColor, "Image",
               ImageMessage(kFirst_ns + 500 * kMillisecond_ns, "rgb8", 2, 1, 6, kRgb));
    const std::string bytes = writer.Finish();
    const Bag bag = Read(bytes);
    EXPECT_EQ(bag.color_topic, kColor);
    EXPECT_EQ(bag.depth_topic, kDepth);
    EXPECT_THAT(bag.list.notes, ElementsAre("1 colour images without depth within 20 ms"));
    ASSERT_EQ(bag.list.frames.size(), 1U) << compression;
    const FrameFiles& frame = bag.list.frames.front();
    EXPECT_EQ(frame.id, "1700000000.250000000");
    EXPECT_EQ(frame.captured_at->seconds(), 1'700'000'000);
    EXPECT_EQ(frame.color_path, std::string("b.mcap: image 1 of ") + kColor);
    EXPECT_EQ(Color(frame).at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 255)) << "blue first";
    EXPECT_EQ(Color(frame).at<cv::Vec3b>(0, 1), cv::Vec3b(0x40, 0, 0));
    EXPECT_EQ(Depth(frame).at<std::uint16_t>(0, 0), 1000);
    EXPECT_EQ(Depth(frame).at<std::uint16_t>(0, 1), 2500);
    const std::optional<Calibration> camera = ColorCameraOf(bag);
    ASSERT_TRUE(camera);
    EXPECT_EQ(bag.info_topic, "/camera/color/camera_info");
    EXPECT_EQ(camera->fx, 525);
    EXPECT_EQ(camera->cx, 0.5);
    ASSERT_TRUE(camera->distortion);
    EXPECT_EQ(camera->distortion->coefficients(0), -0.25);
  }
}

// As drivers send it that do not register depth.
TEST(Bag, DepthOfAnotherFrameIsNoted) {
  const auto note_of = [](const char* depth_frame) {
    BagWriter writer;
    writer.Add(kColor, "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb, "color_optical"));
    writer.Add(kDepth, "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits, depth_frame));
    return NoteOfUnregistered(Read(writer.Finish()));
  };
  EXPECT_THAT(note_of("depth_optical"),
              HasSubstr("depth is of the frame depth_optical, colour of color_optical"));
  EXPECT_EQ(note_of("color_optical"), "");
  EXPECT_EQ(note_of(""), "") << "of none that is known";
}

Bag WithInfo(const std::string& color_topic, const std::string& info_topic,
             const std::string& info) {
  BagWriter writer;
  writer.Add(info_topic, "CameraInfo", info);
  writer.Add(color_topic, "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.Add(kDepth, "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  return Read(writer.Finish());
}

TEST(Bag, RectifiedImagesHaveNoDistortion) {
  const std::string info = CameraInfoMessage(2, 1, 400, -0.25);
  const auto camera =
      ColorCameraOf(WithInfo("/camera/color/image_rect_color", "/camera/color/camera_info", info));
  ASSERT_TRUE(camera);
  EXPECT_EQ(camera->fx, 300) << "of P";
  EXPECT_EQ(camera->fy, 300);
  EXPECT_EQ(camera->cx, 0.5);
  EXPECT_FALSE(camera->distortion);
}

// K = [fx / binning, (cx - offset) / binning], as image_geometry has it.
TEST(Bag, CameraInfoOfImagesThatAreCutOutAndBinned) {
  const auto camera_of = [](const testing::Window& window) {
    const char* topic = "/camera/color/camera_info";
    return *ColorCameraOf(WithInfo(kColor, topic, CameraInfoMessage(641, 481, 600, -0.25, window)));
  };
  const Calibration binned = camera_of({.binning_x = 2, .binning_y = 4});
  EXPECT_EQ(binned.fx, 300);
  EXPECT_EQ(binned.fy, 150);
  EXPECT_EQ(binned.cx, 160);
  EXPECT_EQ(binned.cy, 60);
  EXPECT_EQ(binned.width, 320);
  EXPECT_EQ(binned.height, 120);
  EXPECT_EQ(binned.distortion->coefficients(0), -0.25);
  const Calibration cut = camera_of({2, 1, 100, 40, 300, 200});
  EXPECT_EQ(cut.fx, 300);
  EXPECT_EQ(cut.fy, 600);
  EXPECT_EQ(cut.cx, 110);
  EXPECT_EQ(cut.cy, 200);
  EXPECT_EQ(cut.width, 100);
  EXPECT_EQ(cut.height, 300);
  EXPECT_THROW(camera_of({.x_offset = 600, .width = 42}), std::invalid_argument);
  EXPECT_THROW(camera_of({.binning_y = 482}), std::invalid_argument);
}

// As cameras that nobody has calibrated send it.
TEST(Bag, CameraInfoWithoutNumbersMattersWhereItIsNeeded) {
  const std::string uncalibrated = CameraInfoMessage(2, 1, 0);
  EXPECT_FALSE(ColorCameraOf(WithInfo(kColor, "/gripper/camera_info", uncalibrated)));
  const Bag bag = WithInfo(kColor, "/camera/color/camera_info", uncalibrated);
  EXPECT_EQ(bag.list.frames.size(), 1U);
  try {
    ColorCameraOf(bag);
    ADD_FAILURE() << "a camera without focal lengths";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("/camera/color/camera_info: it is of no camera (K, width"));
  }
}

TEST(Bag, ReadsOtherEncodings) {
  const std::string float_bag =
      BagOf("Image", ImageMessage(kFirst_ns, "bgra8", 2, 1, 8, std::string("\1\2\3\0\4\5\6\0", 8)),
            "Image", ImageMessage(kFirst_ns, "32FC1", 2, 1, 8, Meters(1.2344F, NAN)));
  const Bag floats = Read(float_bag);
  EXPECT_EQ(Color(floats.list.frames.at(0)).at<cv::Vec3b>(0, 1), cv::Vec3b(4, 5, 6));
  EXPECT_EQ(Depth(floats.list.frames.at(0)).at<std::uint16_t>(0, 0), 1234);
  EXPECT_EQ(Depth(floats.list.frames.at(0)).at<std::uint16_t>(0, 1), 0);

  const FrameFiles& frame = floats.list.frames.front();
  const std::string packed =
      BagOf("CompressedImage", CompressedMessage(kFirst_ns, "rgb8; png", frame.read_color()),
            "CompressedImage",
            CompressedMessage(kFirst_ns, "16UC1; compressedDepth png",
                              std::string(12, 'x') + frame.read_depth()));
  const Bag files = Read(packed);
  EXPECT_EQ(files.list.frames.at(0).read_color(), frame.read_color());
  EXPECT_EQ(files.list.frames.at(0).read_depth(), frame.read_depth());
}

TEST(Bag, DepthInMetersBecomesTheUnitsThatAreSent) {
  const std::string bag = BagOf("Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb), "Image",
                                ImageMessage(kFirst_ns, "32FC1", 2, 1, 8, Meters(1.25F, 7)));
  const Bag tenths = Read(bag, {.depth_unit_m = 0.0001});
  EXPECT_EQ(Depth(tenths.list.frames.at(0)).at<std::uint16_t>(0, 0), 12500);
  EXPECT_EQ(Depth(tenths.list.frames.at(0)).at<std::uint16_t>(0, 1), 0) << "too far for 16 bits";
}

// As they are where somebody sends millimetres as 32FC1.
TEST(Bag, DepthInMetersThatIsTooFarForAllBitsIsRefused) {
  const auto why_not = [](float first, float second) {
    return WhyNot(BagOf("Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb), "Image",
                        ImageMessage(kFirst_ns, "32FC1", 2, 1, 8, Meters(first, second))));
  };
  EXPECT_THAT(why_not(1250, 812), HasSubstr("which is in metres, is 812 m, and 16 bits hold "
                                            "65.535 m: check its unit"));
  EXPECT_EQ(why_not(1250, 65.5F), "");
  EXPECT_EQ(why_not(NAN, INFINITY), "") << "of nothing that was measured";
  EXPECT_EQ(why_not(0, 1e-5F), "");
}

TEST(Bag, SaysWhyThereIsNoFrame) {
  BagWriter writer;
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.EndChunk("zstd");
  const std::string alone = writer.Finish();
  EXPECT_EQ(WhyNot(alone.substr(0, 100)),
            "it has no images of ROS 2; b.mcap breaks off at byte 33 of 100");
  EXPECT_EQ(WhyNot(BagOf("String", "a", "String", "b")), "it has no images of ROS 2");
  const std::string late = ImageMessage(kFirst_ns + 50 * kMillisecond_ns, "16UC1", 2, 1, 4, kUnits);
  EXPECT_EQ(WhyNot(BagOf("Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb), "Image", late)),
            "it has no frames; 1 colour images without depth within 20 ms; 1 depth images without "
            "colour within 20 ms");
}

TEST(Bag, SaysWhatIsWrong) {
  const std::string color = ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb);
  const std::string depth = ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits);
  EXPECT_EQ(WhyNot(BagOf("Image", color, "Image", depth)), "");
  EXPECT_EQ(WhyNot("#ROSBAG V2.0"), "it is no MCAP file");
  const auto why_not_color = [&](const std::string& message) {
    return WhyNot(BagOf("Image", message, "Image", depth));
  };
  EXPECT_THAT(why_not_color(ImageMessage(kFirst_ns, "rgb8", 2, 1, 5, kRgb)),
              HasSubstr("fewer bytes"));
  EXPECT_THAT(why_not_color(ImageMessage(kFirst_ns, "rgb8", 2, 2, 6, kRgb)),
              HasSubstr("fewer bytes"));
  EXPECT_THAT(why_not_color(ImageMessage(kFirst_ns, "rgb8", 4'000'000'000, 1, 6, kRgb)),
              HasSubstr("not from 1 to 32768"));
  EXPECT_THAT(why_not_color(color.substr(0, 20)), HasSubstr("image 1 of /rgb: it ends too early"));
  EXPECT_THAT(why_not_color(color.substr(0, 30)), HasSubstr("ends too early"));
  EXPECT_THAT(why_not_color("\1\1\1\1" + color.substr(4)), HasSubstr("not in little-endian CDR"));
  EXPECT_THAT(why_not_color(ImageMessage(-kFirst_ns, "rgb8", 2, 1, 6, kRgb)),
              HasSubstr("time is none"));
}

TEST(Topics, AreChosenByName) {
  const std::vector<std::string> realsense{
      "/camera/aligned_depth_to_color/image_raw", "/camera/color/image_raw",
      "/camera/color/image_raw/compressed", "/camera/depth/image_rect_raw",
      "/camera/infra1/image_rect_raw"};
  EXPECT_EQ(ColorTopic(realsense, ""), "/camera/color/image_raw");
  EXPECT_EQ(DepthTopic(realsense, ""), "/camera/aligned_depth_to_color/image_raw");
  EXPECT_EQ(DepthTopic(realsense, "/camera/depth/image_rect_raw"), "/camera/depth/image_rect_raw");
  EXPECT_THROW(DepthTopic(realsense, "/none"), std::invalid_argument);
  EXPECT_THROW(ColorTopic({"/left/image", "/right/image"}, ""), std::invalid_argument);
  EXPECT_THROW(DepthTopic({"/left/image"}, ""), std::invalid_argument);
  const std::vector<std::string> infos{"/a/camera_info", "/a/color/camera_info", "/camera_info"};
  EXPECT_EQ(InfoTopic(infos, "/a/color/image_raw"), "/a/color/camera_info");
  EXPECT_EQ(InfoTopic(infos, "/a/b/image_raw"), "/a/camera_info");
  EXPECT_EQ(InfoTopic({"/b/camera_info"}, "/a/image_raw"), "");
  EXPECT_EQ(InfoTopic({"/a/camera_info", "/a/depth_camera_info"}, "/a/image_raw"),
            "/a/camera_info");
  EXPECT_EQ(InfoTopic({"/a/depth_info", "/a/rgb_info"}, "/a/rgb"), "/a/rgb_info");
  EXPECT_EQ(InfoTopic({"/a/left_info", "/a/right_info"}, "/a/image"), "") << "either may be meant";
}

}  // namespace
}  // namespace fovea::cli::small_bags
