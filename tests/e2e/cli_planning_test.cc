// What motion planners ask for, from the command line.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/e2e/cli_fixture.h"
#include "tests/support/random_scene.h"
#include "tests/support/scene_files.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

class CliPlanningTest : public CliTest {
 protected:
  CliPlanningTest() {
    scenes::WriteFrame(Folder(), "s",
                       scenes::MakeFrame(scenes::RandomScene("tabletop", /*seed=*/1, {320, 240}),
                                         scenes::SensorKind::kKinect, /*seed=*/1));
  }

  Finished DetectScene(std::vector<std::string> flags) {
    flags.insert(flags.begin(), {FOVEA_CLI, "detect", "--server", server_.address(), "--intrinsics",
                                 "262.5,262.5,159.5,119.5"});
    return Execute(flags);
  }

  // The answer to these flags.
  json AnswerTo(std::vector<std::string> flags) {
    flags.insert(flags.end(), {"--color", At("s_color.png"), "--depth", At("s_depth.png"), "--json",
                               At("j.json"), "--no-masks"});
    const Finished finished = DetectScene(flags);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    out_ = finished.out;
    return json::parse(std::ifstream(At("j.json")));
  }

  std::string out_;
};

TEST_F(CliPlanningTest, AsksForWhatPlannersNeed) {
  const json answer = AnswerTo({"--collision-primitives", "--height-map-cell", "0.05",
                                "--height-map-max-cells", "50", "--camera-pose", "1,2,3,0,0,0,1"});
  ASSERT_FALSE(answer.at("objects").empty());
  for (const json& object : answer["objects"]) {
    EXPECT_GT(object.at("collision").at("size").at("x"), 0);
    const json& at = object.at("oriented_box").at("pose").at("position");
    EXPECT_EQ(object.at("pose_in_reference").at("position").at("z"), 3 + at.at("z").get<double>());
  }
  EXPECT_EQ(answer.at("support_collisions").at(0).at("kind"), "COLLISION_KIND_BOX");
  const json& map = answer.at("height_map");
  EXPECT_FLOAT_EQ(map.at("cell_m"), 0.05F);
  EXPECT_LE(map.at("width").get<int>() * map.at("height").get<int>(), 50);
  EXPECT_EQ(answer.at("frame").at("camera_pose").at("position").at("y"), 2);
  EXPECT_THAT(out_, HasSubstr("by --camera-pose, m"));
  EXPECT_THAT(out_, HasSubstr("\nheight map of "));

  const json plain = AnswerTo({});
  EXPECT_FALSE(plain.contains("height_map"));
  EXPECT_TRUE(plain.at("support_collisions").empty());
}

TEST_F(CliPlanningTest, SaysHowManyPlacesAndHowMuchRoom) {
  EXPECT_EQ(AnswerTo({"--place", "0.05,0.05,0.05"}).at("free_places").size(), 5U);
  EXPECT_EQ(AnswerTo({"--place", "0.05,0.05,0.05", "--max-places", "2"}).at("free_places").size(),
            2U);
  EXPECT_TRUE(
      AnswerTo({"--place", "0.05,0.05,0.05", "--place-margin", "1"}).at("free_places").empty());
}

TEST_F(CliPlanningTest, DrawsHeightsAndCollisions) {
  AnswerTo({"--height-map", At("h.png"), "--overlay", At("o.png")});
  EXPECT_FALSE(cv::imread(At("h.png")).empty());
  const cv::Mat plain = cv::imread(At("o.png"));
  AnswerTo({"--show", "collisions", "--overlay", At("o.png")});
  EXPECT_GT(cv::norm(plain, cv::imread(At("o.png"))), 0);

  fs::remove(At("a_color.png"));  // the fixture's
  const Finished folder = DetectScene(
      {"--input", Folder(), "--output", At("out"), "--height-map", "jpg", "--no-overlay"});
  EXPECT_EQ(folder.exit_code, 0) << folder.err;
  EXPECT_FALSE(cv::imread(At("out/s_height.jpg")).empty());
}

TEST_F(CliPlanningTest, NamesTheFlagThatIsWrong) {
  ExpectOneLineError(DetectFrame({"--camera-pose", "0,0,1"}),
                     "--camera-pose: \"0,0,1\" is not X,Y,Z,QX,QY,QZ,QW");
  ExpectOneLineError(DetectFrame({"--camera-pose", "0,0,1,0,0,0,2"}),
                     "INVALID_ARGUMENT: frame.camera_pose.orientation: ");
  ExpectOneLineError(DetectFrame({"--place-margin", "0.1"}), "--place-margin requires --place");
  ExpectOneLineError(DetectFrame({"--place", "1,1,1", "--place-margin", "nan"}),
                     "--place-margin: \"nan\" is not a number from 0 to 1");
  ExpectOneLineError(DetectFrame({"--place", "1,1,1", "--max-places", "0"}), "--max-places: ");
  ExpectOneLineError(DetectFrame({"--height-map-cell", "0"}),
                     "--height-map-cell: \"0\" is not a number from 0.002 to 1");
  ExpectOneLineError(DetectFrame({"--height-map-max-cells", "1048577"}),
                     "--height-map-max-cells: ");
  ExpectOneLineError(DetectFrame({"--height-map", At("h")}), "--height-map: cannot write ");
  ExpectOneLineError(
      Detect({"--input", Folder(), "--output", At("out"), "--height-map", At("h.png")}),
      "--height-map: of a folder it is jpg");
  ExpectOneLineError(Detect({"--input", Folder(), "--json", "-", "--height-map", "jpg"}),
                     "--height-map of a folder needs --output");
}

}  // namespace
}  // namespace fovea::testing
