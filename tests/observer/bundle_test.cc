// Bundles: what is written is read again, and what is none is refused.
#include "client/bundle/bundle.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "client/bundle/comparison.h"
#include "client/bundle/readable_files.h"
#include "client/bundle/zip_writer.h"
#include "client/image_files/image_files.h"
#include "client/rvl.h"
#include "tests/server/frames.h"

namespace fovea::testing {
namespace {

using bundle::Bundle;
using bundle::BundledFrame;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

BundledFrame TestBundledFrame() {
  BundledFrame frame{.request = TestRequest(), .answer = v1::Detections()};
  frame.answer->set_width(kWidth);
  frame.answer->set_height(kHeight);
  frame.answer->add_objects()->set_label(1);
  return frame;
}

std::string ErrorOf(const std::string& bytes, const bundle::ZipLimits& limits = {}) {
  try {
    const Bundle bundle(bytes, limits);
    for (const std::string& name : bundle.names()) bundle.RequestOf(name);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(ObserverBundle, HoldsWhatWasSentAndAnswered) {
  BundledFrame refused = TestBundledFrame();
  refused.answer.reset();
  refused.error = v1::FrameError();
  const BundledFrame good = TestBundledFrame();
  const Bundle bundle(bundle::WriteBundle({good, refused}, {.made_by = "test"}));
  ASSERT_THAT(bundle.names(), ElementsAre("frame_0001", "frame_0002"));
  EXPECT_EQ(bundle.RequestOf("frame_0001").SerializeAsString(), good.request.SerializeAsString());
  EXPECT_EQ(bundle::BytesOf(*bundle.AnswerOf("frame_0001")), bundle::BytesOf(*good.answer));
  EXPECT_FALSE(bundle.AnswerOf("frame_0002"));
  EXPECT_FALSE(bundle.ColorFileOf("frame_0001").empty());
  EXPECT_FALSE(bundle.DepthFileOf("frame_0001").empty());
}

TEST(ObserverBundle, OfTheSameFramesIsTheSameFile) {
  EXPECT_EQ(bundle::WriteBundle({TestBundledFrame()}, {.made_by = "test"}),
            bundle::WriteBundle({TestBundledFrame()}, {.made_by = "test"}));
}

TEST(ObserverBundle, HasReadableImagesOfEveryEncoding) {
  const cv::Mat depth = TestDepth();
  for (const v1::DepthImage& image : TestDepths()) {
    const auto file = bundle::DepthFile(image);
    ASSERT_TRUE(file) << image.encoding();
    EXPECT_EQ(cv::norm(image_files::DecodeDepth(file->bytes), depth, cv::NORM_INF), 0)
        << image.encoding();
  }
  for (const v1::ColorImage& image : TestColors()) {
    const auto file = bundle::ColorFile(image);
    ASSERT_TRUE(file) << image.encoding();
    cv::Mat rgb;
    cv::cvtColor(image_files::DecodeColor(file->bytes), rgb, cv::COLOR_BGR2RGB);
    const double loss = image.encoding() == v1::COLOR_ENCODING_JPEG ? 12 : 0;
    EXPECT_LE(cv::norm(rgb, TestColor(), cv::NORM_INF), loss) << image.encoding();
  }
}

TEST(ObserverBundle, HasNoImageFileOfWhatIsNoImage) {
  EXPECT_FALSE(bundle::DepthFile(DepthMessage(v1::DEPTH_ENCODING_16UC1, "short", 4, 4)));
  EXPECT_FALSE(bundle::DepthFile(DepthMessage(v1::DEPTH_ENCODING_16UC1_RVL, "shor", 4, 4)));
  EXPECT_FALSE(bundle::DepthFile(DepthMessage(v1::DEPTH_ENCODING_16UC1_ZSTD, "short", 4, 4)));
  EXPECT_FALSE(
      bundle::DepthFile(DepthMessage(v1::DEPTH_ENCODING_16UC1, "", 0xFFFFFFFF, 0xFFFFFFFF)));
  BundledFrame frame = TestBundledFrame();
  frame.request.mutable_frame()->mutable_color()->set_data("short");
  const Bundle bundle(bundle::WriteBundle({frame}, {}));
  EXPECT_EQ(bundle.RequestOf("frame_0001").SerializeAsString(), frame.request.SerializeAsString());
  EXPECT_THROW(bundle.ColorFileOf("frame_0001"), std::invalid_argument);
}

TEST(ObserverBundle, ThatIsSpoiledIsRefused) {
  const std::string good = bundle::WriteBundle({TestBundledFrame()}, {.made_by = "test"});
  EXPECT_EQ(ErrorOf(good), "none");
  EXPECT_THAT(ErrorOf(""), HasSubstr("no bundle.json"));
  EXPECT_THAT(ErrorOf(good.substr(0, good.size() / 2)), HasSubstr("no readable zip file"));
  for (std::size_t at = 0; at < good.size(); at += 97) {  // ends in words, whatever is wrong
    std::string bad = good;
    bad[at] = static_cast<char>(~bad[at]);
    EXPECT_FALSE(ErrorOf(bad).empty());
  }
}

TEST(ObserverBundle, ThatIsTooLargeIsRefusedUnopened) {
  const std::string good = bundle::WriteBundle({TestBundledFrame()}, {.made_by = "test"});
  EXPECT_THAT(ErrorOf(good, {.max_entries = 3}), HasSubstr("more than 3"));
  EXPECT_THAT(ErrorOf(good, {.max_entry_bytes = 10}), HasSubstr("of more than"));
  EXPECT_THAT(ErrorOf(good, {.max_total_bytes = 1000}), HasSubstr("unpacks to more than"));
  bundle::ZipWriter bomb(0);
  bomb.Add("bundle.json", std::string(std::size_t{65} << 20, '0'));
  const std::string small = bomb.Finish();
  EXPECT_LT(small.size(), std::size_t{1} << 20);
  EXPECT_THAT(ErrorOf(small), HasSubstr("\"bundle.json\" of more than 64 MiB"));
}

TEST(ObserverBundle, HoldsNoTextThatItsReadersRefuse) {
  BundledFrame large = TestBundledFrame();
  large.answer->mutable_objects(0)->mutable_cloud()->set_colors(
      std::string(std::size_t{50} << 20, 0));
  const std::string file = bundle::WriteBundle({large}, {.made_by = "test"});
  EXPECT_EQ(ErrorOf(file), "none");
  EXPECT_EQ(Bundle(file).AnswerOf("frame_0001")->ByteSizeLong(), large.answer->ByteSizeLong());
}

TEST(ObserverBundle, WithNamesThatLeadElsewhereIsRefused) {
  for (const char* name : {"../x_request.pb", "/etc/x_request.pb", "a/b_request.pb",
                           "a\\b_request.pb", ".x_request.pb", "x\ny_request.pb", ""}) {
    bundle::ZipWriter zip(0);
    zip.Add("bundle.json", R"({"format":"fovea-bundle","version":1})");
    zip.Add(name, "");
    EXPECT_THAT(ErrorOf(zip.Finish()), HasSubstr("which is no plain file name")) << name;
  }
}

TEST(ObserverBundle, ComparesAnswersByWhatWasAskedFor) {
  v1::Detections then, now;
  then.add_objects()->set_label(1);
  now = then;
  now.mutable_objects(0)->mutable_mask()->add_runs(4);
  now.add_stage_times()->set_stage("queue");
  now.set_track_epoch(3);
  now.mutable_objects(0)->mutable_collision();
  now.add_support_collisions();
  now.mutable_height_map();
  v1::DetectOptions asked;
  EXPECT_EQ(bundle::CompareAnswers(then, now, asked), "the same answer as then");
  asked.set_return_masks(true);
  EXPECT_THAT(bundle::CompareAnswers(then, now, asked), HasSubstr("another answer than then"));
  asked.mutable_planning()->mutable_height_map();
  now = then;
  now.mutable_height_map();
  EXPECT_THAT(bundle::CompareAnswers(then, now, asked), HasSubstr("another answer than then"));
  now = then;
  now.set_server_version("2");
  EXPECT_THAT(bundle::CompareAnswers(then, now, asked),
              HasSubstr("the same answer as then, by server"));
  now.add_objects();
  EXPECT_THAT(bundle::CompareAnswers(then, now, asked), HasSubstr("1 object then, 2 now"));
  then.set_server_version("\x1b[2J");  // of whoever made the bundle, for somebody's terminal
  EXPECT_THAT(bundle::CompareAnswers(then, now, asked), HasSubstr("server ?[2J () then"));
}

TEST(ObserverRvl, DecodesWhatWasEncodedAndNothingElse) {
  const cv::Mat depth = TestDepth();
  std::string codes = RvlOf(depth);
  cv::Mat decoded(depth.size(), CV_16UC1);
  ASSERT_TRUE(client::DecodeRvl(codes, decoded.ptr<std::uint16_t>(), decoded.total()));
  EXPECT_EQ(cv::norm(decoded, depth, cv::NORM_INF), 0);
  EXPECT_FALSE(
      client::DecodeRvl(codes.substr(0, 4), decoded.ptr<std::uint16_t>(), decoded.total()));
  EXPECT_FALSE(client::DecodeRvl("abc", decoded.ptr<std::uint16_t>(), decoded.total()));
  EXPECT_FALSE(client::DecodeRvl("\xFF\xFF\xFF\xFF", decoded.ptr<std::uint16_t>(), 1));
}

}  // namespace
}  // namespace fovea::testing
