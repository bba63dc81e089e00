#include "client/cli/mcap/bag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <opencv2/core.hpp>

#include "client/cli/files.h"
#include "client/cli/mcap/topics.h"
#include "tests/support/bag_writer.h"
#include "tests/support/temporary_folder.h"

namespace fovea::cli {
namespace {

using testing::BagWriter;
using testing::CameraInfoMessage;
using testing::CompressedMessage;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ImageMessage;

constexpr std::int64_t kFirst_ns = 1'700'000'000'250'000'000, kMillisecond_ns = 1'000'000;
constexpr const char* kColor = "/camera/color/image_raw";
constexpr const char* kDepth = "/camera/aligned_depth_to_color/image_raw";

// Two by one pixels: red and dark blue; 1 m and 2.5 m.
const std::string kRgb{"\xFF\0\0\0\0\x40", 6}, kUnits{"\xE8\x03\xC4\x09", 4};

std::string Meters(float first, float second) {
  std::string bytes(8, '\0');
  std::memcpy(bytes.data(), &first, sizeof first);
  std::memcpy(bytes.data() + 4, &second, sizeof second);
  return bytes;
}

Bag Read(const std::string& bytes, const BagFlags& flags = {}) {
  return ReadBag(McapInMemory(bytes), "b.mcap", flags);
}

std::string WhyNot(const std::string& bytes, const BagFlags& flags = {}) {
  try {
    for (const FrameFiles& frame : Read(bytes, flags).list.frames) {
      frame.read_color();
      frame.read_depth();
    }
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

cv::Mat Color(const FrameFiles& frame) { return DecodeColor(frame.read_color(), "c"); }
cv::Mat Depth(const FrameFiles& frame) { return DecodeDepth(frame.read_depth(), "d"); }

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

// A bag of one frame.
std::string BagOf(const std::string& color_type, const std::string& color,
                  const std::string& depth_type, const std::string& depth) {
  BagWriter writer;
  writer.Add("/rgb", color_type, color);
  writer.Add("/depth", depth_type, depth);
  return writer.Finish();
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

TEST(Bag, OfARecorderThatWasKilledIsReadUntilThere) {
  BagWriter writer;
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.Add("/depth", "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  writer.EndChunk("zstd");
  const std::size_t whole = writer.Finish().size();
  writer.Add("/rgb", "Image", ImageMessage(2 * kFirst_ns / 3, "rgb8", 2, 1, 6, kRgb));
  const std::string cut = writer.Finish().substr(0, whole - 20);
  const Bag bag = Read(cut);
  EXPECT_EQ(bag.list.frames.size(), 1U);
  EXPECT_THAT(bag.list.notes, ElementsAre(HasSubstr("b.mcap breaks off at byte ")));
}

// As by a recorder that limits its files, or a disk that loses them.
TEST(Bag, ThatIsShortenedMeanwhileFailsItsFrames) {
  const std::string bag = BagOf("Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb), "Image",
                                ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  const testing::TemporaryFolder folder;
  const std::string path = folder.Write("b.mcap", bag);
  const Bag open = OpenBag(path, {});
  EXPECT_EQ(Color(open.list.frames.at(0)).cols, 2);
  std::filesystem::resize_file(path, 0);
  EXPECT_THROW(open.list.frames.at(0).read_color(), std::invalid_argument);
}

// Between two records, or where a disk has zeros for what was written last.
TEST(Bag, ThatHasNoEndIsNoted) {
  const std::string bag = BagOf("Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb), "Image",
                                ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  constexpr std::size_t kEnd = (9 + 4) + (9 + 20) + 8;  // DataEnd, Footer, and what ends a file
  const std::string cut = bag.substr(0, bag.size() - kEnd), at = std::to_string(cut.size());
  EXPECT_THAT(Read(bag).list.notes, ::testing::IsEmpty());
  EXPECT_THAT(Read(cut).list.notes, ElementsAre(HasSubstr("at byte " + at + " of " + at)));
  EXPECT_THAT(Read(cut + std::string(90, '\0')).list.notes,
              ElementsAre(HasSubstr("at byte " + at + " of ")));
}

// One byte of a chunk in the middle, compressed, or plain with and without a checksum.
TEST(Bag, OfDamagedChunksTheOthersAreRead) {
  const auto bag_of = [](const char* compression, bool with_checksum) {
    BagWriter writer;
    for (int i = 0; i < 3; ++i) {
      const std::int64_t time_ns = kFirst_ns + i * 100 * kMillisecond_ns;
      writer.Add("/rgb", "Image", ImageMessage(time_ns, "rgb8", 2, 1, 6, kRgb));
      writer.Add("/depth", "Image", ImageMessage(time_ns, "16UC1", 2, 1, 4, kUnits));
      writer.EndChunk(compression, with_checksum);
    }
    return writer.Finish();
  };
  const auto damaged = [](std::string bag, std::size_t at) {
    bag[at] ^= 1;
    return Read(bag);
  };
  const std::string plain = bag_of("", false), checked = bag_of("", true);
  const std::size_t second = plain.find(kUnits, plain.find(kUnits) + 1);
  EXPECT_THAT(damaged(plain, second).list.notes, ::testing::IsEmpty()) << "nobody can know";

  const Bag bag = damaged(checked, second);
  ASSERT_EQ(bag.list.frames.size(), 2U);
  EXPECT_EQ(bag.list.frames[1].id, "1700000000.450000000");
  EXPECT_EQ(Depth(bag.list.frames[1]).at<std::uint16_t>(0, 1), 2500);
  const std::size_t at = 33 + (plain.size() - 33 - (9 + 4) - (9 + 20) - 8) / 3;
  EXPECT_THAT(bag.list.notes,
              ElementsAre("b.mcap has damaged records: 1, the first at byte " + std::to_string(at) +
                          ": a chunk is damaged: its checksum is another; what else it has is "
                          "read"));
  const std::string packed = bag_of("zstd", false);
  const std::size_t name = packed.find("zstd", packed.find("zstd") + 1);
  EXPECT_EQ(damaged(packed, name + 4 + 8).list.frames.size(), 2U) << "of the magic number";
}

// As where the chunk that says which topics there are is damaged.
TEST(Bag, MessagesOfNoChannelAreLeftOut) {
  BagWriter writer;
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.Add("/depth", "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  writer.Add("/chatter", "String", "anything");
  writer.EndChunk("");
  std::string bag = writer.Finish();
  const std::string chatter = "/chatter", channel("\3\0\3\0\x08\0\0\0", 8);
  bag[bag.find(channel + chatter)] = '\7';
  EXPECT_EQ(Read(bag).list.frames.size(), 1U);
  EXPECT_THAT(Read(bag).list.notes,
              ElementsAre(HasSubstr("at byte 33: a message is of no channel")));
}

TEST(Bag, SaysWhyThereIsNoFrame) {
  BagWriter writer;
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.EndChunk("zstd");
  const std::string alone = writer.Finish();
  EXPECT_EQ(WhyNot(alone.substr(0, 100)),
            "it has no images of ROS 2; it breaks off at byte 33 of 100");
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
  EXPECT_THAT(why_not_color(ImageMessage(kFirst_ns, "yuv422", 2, 1, 4, "abcd")),
              HasSubstr("encoding \"yuv422\" is no colour"));
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

TEST(Bag, BrokenImagesOfOtherTopicsDoNotMatter) {
  BagWriter writer;
  writer.Add("/infra1/image", "Image", "cut");
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.Add("/depth", "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  const std::string bag = writer.Finish();
  EXPECT_EQ(WhyNot(bag), "");
  EXPECT_EQ(WhyNot(bag, {.color_topic = "/infra1/image"}),
            "image 1 of /infra1/image: a message is not in little-endian CDR");
}

// A chunk that says that it is larger than it is, or than is allowed.
TEST(Bag, BelievesNoSizes) {
  BagWriter writer;
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.EndChunk("zstd");
  const std::string bytes = writer.Finish();
  const std::size_t size_at = bytes.find("zstd") - 16;
  std::string larger = bytes;
  larger[size_at + 3] = '\x0F';  // 240 MB
  EXPECT_EQ(WhyNot(larger),
            "it has no images of ROS 2; it has damaged records: 1, the first at byte 33: a chunk "
            "holds less than it says");
  larger[size_at + 5] = '\1';
  EXPECT_THAT(WhyNot(larger), HasSubstr("larger than 256 MiB"));
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
}

}  // namespace
}  // namespace fovea::cli
