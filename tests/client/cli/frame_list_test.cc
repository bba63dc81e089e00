#include "client/cli/frame_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "client/cli/timed_images.h"
#include "tests/support/temporary_folder.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class FrameListTest : public ::testing::Test {
 protected:
  void Write(const std::string& name, const std::string& text = "x") {
    fs::create_directories(fs::path(folder_.At(name)).parent_path());
    folder_.Write(name, text);
  }
  std::string Input() const { return folder_.At(""); }

  testing::TemporaryFolder folder_;
};

TEST_F(FrameListTest, PairsByNameAndNamesDepthWithoutColour) {
  for (const char* name : {"b_color.jpg", "a_color.png", "a_depth.png", "c_depth.png", "n.txt"}) {
    Write(name);
  }
  const FrameList list = ListFrames(Input());
  ASSERT_EQ(list.frames.size(), 2U);
  EXPECT_EQ(list.frames[0].id, "a");
  EXPECT_EQ(list.frames[1].depth_path, folder_.At("b_depth.png")) << "missing, and told later";
  EXPECT_EQ(list.depth_unit_m, 0.001);
  EXPECT_THAT(list.notes, ElementsAre(folder_.At("c_depth.png") + " has no c_color.png (or .jpg)"));
}

TEST_F(FrameListTest, TakesEndingsInLettersOfEitherCase) {
  for (const char* name : {"A_color.JPG", "A_depth.PNG"}) Write(name);
  const FrameList list = ListFrames(Input());
  ASSERT_EQ(list.frames.size(), 1U);
  EXPECT_EQ(list.frames[0].id, "A");
  EXPECT_EQ(list.frames[0].depth_path, folder_.At("A_depth.PNG"));
  EXPECT_THAT(list.notes, IsEmpty());
}

TEST_F(FrameListTest, ReadsWhatFoveaCaptureKeptOfTheCameras) {
  for (const char* name : {"1_color.png", "1_depth.png"}) Write(name);
  EXPECT_FALSE(ListFrames(Input()).captured) << "as an older version left it";

  v1::Frame frame;
  frame.mutable_depth()->set_unit_m(0.0005);
  WriteCaptureFile(Input(), frame);
  const FrameList registered = ListFrames(Input());
  EXPECT_EQ(registered.depth_unit_m, 0.0005);
  EXPECT_FALSE(registered.captured->depth_camera);

  frame.mutable_depth_intrinsics()->set_fx(501);
  frame.mutable_depth_intrinsics()->mutable_distortion()->add_coefficients(0.1);
  frame.mutable_color_from_depth()->mutable_position()->set_x(0.05);
  WriteCaptureFile(Input(), frame);
  const auto camera = ListFrames(Input()).captured->depth_camera;
  ASSERT_TRUE(camera);
  EXPECT_EQ(camera->intrinsics.SerializeAsString(), frame.depth_intrinsics().SerializeAsString());
  EXPECT_EQ(camera->color_from_depth.position().x(), 0.05);
}

TEST_F(FrameListTest, NamesWhatIsWrongWithThem) {
  for (const char* name : {"1_color.png", "1_depth.png"}) Write(name);
  const auto problem = [&](const std::string& text) {
    Write("fovea_capture.json", text);
    try {
      ListFrames(Input());
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string path = folder_.At("fovea_capture.json");
  EXPECT_THAT(problem("x"), HasSubstr(path + ": it is not JSON"));
  EXPECT_THAT(problem(R"({"depth": {"unit_m": 2}})"), HasSubstr(path + ": depth.unit_m must be"));
  EXPECT_THAT(problem(R"({"depth": {"unit_m": "NaN"}})"), HasSubstr("depth.unit_m must be"));
  EXPECT_THAT(problem(R"({"depth": {"unit_m": 1}, "color_from_depth": {}})"),
              HasSubstr(path + ": depth_intrinsics and color_from_depth go together"));
  EXPECT_EQ(problem(R"({"depth": {"unit_m": 1}, "of_a_later_version": 1})"), "");
}

TEST(NameApart, GivesEachFrameANameOfItsOwn) {
  const std::vector<std::string> given{"a", "a", "b", "a_2", "a", "fovea_request", "fovea_input"};
  std::vector<FrameFiles> frames(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) frames[i].id = given[i];
  EXPECT_EQ(NameApart(frames), 4U);
  std::vector<std::string> ids(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) ids[i] = frames[i].id;
  EXPECT_THAT(ids, ElementsAre("a", "a_3", "b", "a_2", "a_4", "fovea_request_2", "fovea_input_2"));
}

// As in the TUM RGB-D benchmark: the cameras run apart from each other.
TEST_F(FrameListTest, ReadsTumFoldersByTime) {
  Write("rgb.txt",
        "# color images\n# file: 'rgbd_dataset_freiburg1_xyz.bag'\n# timestamp filename\n"
        "1305031102.211214 rgb/1305031102.211214.png\n"
        "1305031102.175304 rgb/1305031102.175304.png\n"
        "1305031102.900000 rgb/1305031102.900000.png\n");
  Write("depth.txt",
        "# depth maps\n1305031102.160407 depth/1305031102.160407.png\n"
        "1305031102.194330 depth/1305031102.194330.png\n"
        "1305031102.226738 depth/1305031102.226738.png\n");
  const FrameList list = ListFrames(Input());
  ASSERT_EQ(list.frames.size(), 2U);
  EXPECT_EQ(list.frames[0].id, "1305031102.175304");
  EXPECT_EQ(list.frames[0].color_path, folder_.At("rgb/1305031102.175304.png"));
  EXPECT_EQ(list.frames[0].depth_path, folder_.At("depth/1305031102.160407.png"));
  EXPECT_EQ(list.frames[0].captured_at->seconds(), 1305031102);
  EXPECT_EQ(list.frames[0].captured_at->nanos(), 175304000);
  EXPECT_EQ(list.frames[1].depth_path, folder_.At("depth/1305031102.226738.png"));
  EXPECT_DOUBLE_EQ(list.depth_unit_m, 1.0 / 5000);
  EXPECT_THAT(list.notes, ElementsAre("1 colour images without depth within 20 ms",
                                      "1 depth images without colour within 20 ms"));
}

TEST_F(FrameListTest, ReadsNamesWithSpacesInTumsLists) {
  Write("rgb.txt", "1.5 rgb/desk left 1.png\n");
  Write("depth.txt", "1.5\tdepth/desk left 1.png \r\n");
  const FrameList list = ListFrames(Input());
  ASSERT_EQ(list.frames.size(), 1U);
  EXPECT_EQ(list.frames[0].color_path, folder_.At("rgb/desk left 1.png"));
  EXPECT_EQ(list.frames[0].depth_path, folder_.At("depth/desk left 1.png"));
}

// Which some editors begin files with.
TEST_F(FrameListTest, ReadsTumsListsWithAByteOrderMark) {
  Write("rgb.txt",
        "\xEF\xBB\xBF"
        "1.5 rgb/1.png\n");
  Write("depth.txt", "\xEF\xBB\xBF# depth maps\n1.5 depth/1.png\n");
  EXPECT_EQ(ListFrames(Input()).frames.size(), 1U);
}

// Their folders alone would be read, with another unit of depth.
TEST_F(FrameListTest, HalfOfTumsListsIsNone) {
  for (const char* name : {"rgb/1.5.png", "depth/1.5.png"}) Write(name);
  Write("rgb.txt", "1.5 rgb/1.5.png\n");
  try {
    ListFrames(Input());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("has rgb.txt of TUM without depth.txt"));
  }
  Write("depth.txt", "1.5 depth/1.5.png\n");
  EXPECT_EQ(ListFrames(Input()).depth_unit_m, 1.0 / 5000);
}

TEST_F(FrameListTest, NamesTheLineThatIsBroken) {
  Write("rgb.txt", "# c\n1.5\n");
  Write("depth.txt", "# depth maps\n");
  try {
    ListFrames(Input());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("rgb.txt, line 2: it is not \"time path\""));
  }
}

TEST_F(FrameListTest, PairsFoldersByNameElseByTime) {
  for (const char* name : {"color/000001.jpg", "color/000002.jpg", "depth/000001.png"}) Write(name);
  const FrameList by_name = ListFrames(Input());
  ASSERT_EQ(by_name.frames.size(), 1U);
  EXPECT_EQ(by_name.frames[0].id, "000001");
  EXPECT_FALSE(by_name.frames[0].captured_at) << "a number is no time";
  EXPECT_THAT(by_name.notes, ElementsAre(HasSubstr("1 images in ")));

  for (const char* name : {"t/rgb/1700000000000000000.png", "t/depth/1700000000010000000.png",
                           "t/depth/1700000000500000000.png"}) {
    Write(name);
  }
  const FrameList by_time = ListFrames(folder_.At("t"));
  ASSERT_EQ(by_time.frames.size(), 1U);
  EXPECT_EQ(by_time.frames[0].captured_at->seconds(), 1700000000);
  EXPECT_EQ(by_time.frames[0].depth_path, folder_.At("t/depth/1700000000010000000.png"));
}

// Two cameras with clocks in milliseconds now and then take an image in the same one.
TEST_F(FrameListTest, EqualTimesAreNoNames) {
  for (const char* name : {"rgb/1700000000100", "rgb/1700000000133", "rgb/1700000000166",
                           "depth/1700000000100", "depth/1700000000134", "depth/1700000000165"}) {
    Write(std::string(name) + ".png");
  }
  const FrameList list = ListFrames(Input());
  ASSERT_EQ(list.frames.size(), 3U);
  EXPECT_EQ(list.frames[1].depth_path, folder_.At("depth/1700000000134.png"));
  EXPECT_EQ(list.frames[2].captured_at->nanos(), 166'000'000);
  EXPECT_THAT(list.notes, IsEmpty());
}

TEST_F(FrameListTest, SaysWhatOfFoldersIsLeftOut) {
  for (const char* name : {"n/rgb/a.png", "n/depth/a.png", "n/depth/b.png", "n/depth/c.tiff",
                           "n/rgb/d.webp", "n/rgb/.hidden", "t/rgb/1.5.png", "t/rgb/cover.png",
                           "t/depth/1.51.png", "o/rgb/a.exr", "o/depth/a.npy"}) {
    Write(name);
  }
  const FrameList by_name = ListFrames(folder_.At("n"));
  EXPECT_EQ(by_name.frames.size(), 1U);
  EXPECT_THAT(by_name.notes,
              ElementsAre("1 images in " + folder_.At("n/depth") +
                              " have none of the same name in " + folder_.At("n/rgb"),
                          "files that are no .png, .jpg or .jpeg are left out: 2, the first is " +
                              folder_.At("n/rgb/d.webp")));
  const FrameList by_time = ListFrames(folder_.At("t"));
  EXPECT_EQ(by_time.frames.size(), 1U);
  EXPECT_THAT(by_time.notes,
              ElementsAre("images whose name is no time are left out: 1, the first is " +
                          folder_.At("t/rgb/cover.png")));
  try {
    ListFrames(folder_.At("o"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("left out: 2, the first is " + folder_.At("o/rgb/a.exr")));
  }
}

// Depth of TUM's and ICL-NUIM's sequences is in 1/5000 m, and pairs are those of the list.
TEST_F(FrameListTest, SaysThatAssociationsAreNotRead) {
  for (const char* name : {"rgb/1.5.png", "depth/1.51.png", "associations.txt"}) Write(name);
  const FrameList list = ListFrames(Input());
  EXPECT_EQ(list.frames.size(), 1U);
  EXPECT_THAT(list.notes, ElementsAre(HasSubstr("associations.txt is not read")));
}

TEST_F(FrameListTest, ReadsNoPipesAsTumsLists) {
  Write("depth.txt", "1.0 depth/1.png\n");
  ASSERT_EQ(mkfifo(folder_.At("rgb.txt").c_str(), S_IRUSR | S_IWUSR), 0);
  EXPECT_THROW(ListFrames(Input()), std::runtime_error);
}

TEST_F(FrameListTest, SaysWhatItLookedFor) {
  Write("c_depth.png");
  try {
    ListFrames(Input());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no NAME_color.png"));
    EXPECT_THAT(error.what(), HasSubstr("rgb.txt and depth.txt"));
    EXPECT_THAT(error.what(), HasSubstr("c_depth.png has no c_color.png"));
  }
}

TEST_F(FrameListTest, FilesOfOtherKindsAreNamed) {
  const auto why_not = [](const std::string& path) -> std::string {
    try {
      ListFrames(path);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(why_not(folder_.Write("a.txt", "x")), ::testing::EndsWith("(.zip)"));
  EXPECT_THAT(why_not(folder_.Write("a.bag", "x")), HasSubstr("of ROS 1 have to be converted"));
}

TEST(ParseTime, KnowsUnitsByTheirDigits) {
  EXPECT_EQ(ParseTime("12.5"), 12'500'000'000);
  EXPECT_EQ(ParseTime("1305031102.175304"), 1'305'031'102'175'304'000);
  EXPECT_EQ(ParseTime("1305031102"), 1'305'031'102'000'000'000);
  EXPECT_EQ(ParseTime("1305031102175"), 1'305'031'102'175'000'000);
  EXPECT_EQ(ParseTime("1305031102175304"), 1'305'031'102'175'304'000);
  EXPECT_EQ(ParseTime("1305031102175304001"), 1'305'031'102'175'304'001);
  for (const char* text :
       {"", ".5", "5.", "-1", "1.2.3", "x", "1e9", "99999999999999999999", "99999999999.5"}) {
    EXPECT_FALSE(ParseTime(text)) << text;
  }
}

TEST(PairByTime, GivesEachImageToTheClosest) {
  const auto at = [](std::int64_t ms) {
    return TimedImage{ms * 1'000'000, std::to_string(ms), std::to_string(ms)};
  };
  // 103 is nearer to 104 than 95 is, although 95 comes first.
  const FrameList list = PairByTime({at(95), at(103)}, {at(104)});
  ASSERT_EQ(list.frames.size(), 1U);
  EXPECT_EQ(list.frames[0].id, "103");
  EXPECT_THAT(PairByTime({at(0)}, {at(21)}).frames, IsEmpty());
  EXPECT_EQ(PairByTime({at(0)}, {at(20)}).frames.size(), 1U);
}

}  // namespace
}  // namespace fovea::cli
