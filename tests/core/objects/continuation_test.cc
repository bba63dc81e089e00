#include "core/objects/continuation.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/depth/back_projection.h"

namespace fovea {
namespace {

const Eigen::Vector3f kUp = -Eigen::Vector3f::UnitY();

// A level camera, 160×120, that looks at background 2 m away; rectangles in front of it, each a
// voxel of its own.
class Scene {
 public:
  Scene() : depth_(120, 160, CV_32FC1, cv::Scalar(2)), voxels_(120, 160, CV_32SC1, cv::Scalar(0)) {
    labels_.push_back(0);
    on_wall_.push_back(0);
  }

  void Add(const cv::Rect& rectangle, float z_m, int label, bool on_wall = false) {
    depth_(rectangle).setTo(z_m);
    voxels_(rectangle).setTo(static_cast<int>(labels_.size()));
    labels_.push_back(label);
    on_wall_.push_back(on_wall ? 1 : 0);
  }
  void Forget(const cv::Rect& rectangle) {
    depth_(rectangle).setTo(std::numeric_limits<float>::quiet_NaN());
  }

  std::set<int> Remaining() const {
    VoxelGrid grid;
    grid.voxels.resize(labels_.size());
    grid.voxel_of_pixel = voxels_;
    for (const int voxel : cv::Mat_<int>(voxels_)) ++grid.voxels[voxel].num_points;
    const CameraIntrinsics intrinsics{130, 130, 79.5, 59.5};
    const PlausibleSegments left =
        RemoveContinued(grid, labels_, BackProject(depth_, intrinsics, 10), intrinsics, on_wall_,
                        kUp, {.max_share = 0.4});
    std::set<int> labels(left.labels.begin(), left.labels.end());
    labels.erase(0);
    return labels;
  }

 private:
  cv::Mat depth_, voxels_;
  std::vector<int> labels_;
  std::vector<char> on_wall_;
};

TEST(RemoveContinued, KeepsWhatEndsInTheOpen) {
  Scene scene;
  scene.Add({40, 40, 20, 40}, 1, 1);
  scene.Add({0, 60, 20, 30}, 1, 2);  // cut off at the side
  EXPECT_EQ(scene.Remaining(), (std::set<int>{1, 2}));
}

TEST(RemoveContinued, RemovesALegBehindTheEdgeOfItsTable) {
  Scene scene;
  scene.Add({0, 30, 160, 10}, 0.8F, 0);
  scene.Add({40, 40, 10, 60}, 1.2F, 1);
  EXPECT_TRUE(scene.Remaining().empty());
}

TEST(RemoveContinued, RemovesALegBehindATableWhoseFrontIsTooNearToMeasure) {
  Scene scene;
  scene.Add({0, 20, 160, 10}, 0.8F, 0);
  scene.Forget({0, 30, 160, 12});
  scene.Add({40, 42, 10, 60}, 1.2F, 1);
  EXPECT_TRUE(scene.Remaining().empty());
}

TEST(RemoveContinued, KeepsWhatEndsWellBelowTheEndOfTheImage) {
  Scene scene;
  scene.Forget({0, 0, 160, 12});
  scene.Add({40, 12, 20, 40}, 1, 1);
  EXPECT_EQ(scene.Remaining(), std::set<int>{1});
}

TEST(RemoveContinued, RemovesALegThatGoesOnIntoWhatItCarries) {
  Scene scene;
  scene.Add({20, 30, 100, 20}, 1, 0);
  scene.Add({40, 50, 10, 40}, 1, 1);
  EXPECT_TRUE(scene.Remaining().empty());
}

TEST(RemoveContinued, RemovesTheLowerPartOnceTheUpperOneIsGone) {
  Scene scene;
  scene.Add({0, 10, 160, 10}, 0.8F, 0);
  scene.Add({40, 20, 10, 40}, 1.2F, 1);
  scene.Add({40, 60, 10, 40}, 1.2F, 2);
  EXPECT_TRUE(scene.Remaining().empty());
}

TEST(RemoveContinued, KeepsWhatStandsAgainstAWall) {
  Scene scene;
  scene.Add({0, 0, 160, 60}, 1, 0, true);
  scene.Add({40, 60, 20, 40}, 1, 1);
  EXPECT_EQ(scene.Remaining(), std::set<int>{1});
}

TEST(RemoveContinued, RemovesAStripOfAWallThatTheSideOfTheImageCutsOff) {
  Scene scene;
  scene.Add({0, 0, 30, 50}, 1, 0, true);
  scene.Add({0, 50, 20, 40}, 1, 1);
  EXPECT_TRUE(scene.Remaining().empty());
}

TEST(RemoveContinued, SpecksDoNotHideWhatALegEndsAt) {
  Scene scene;
  scene.Add({0, 30, 160, 10}, 0.8F, 0);
  scene.Add({40, 40, 9, 2}, 1.2F, 2);  // 18 pixels
  scene.Add({40, 42, 9, 60}, 1.2F, 1);
  EXPECT_EQ(scene.Remaining(), (std::set<int>{2}));
}

TEST(RemoveContinued, KeepsTheLowerOfTwoStackedObjects) {
  Scene scene;
  scene.Add({40, 40, 20, 20}, 1, 1);
  scene.Add({40, 60, 20, 20}, 1, 2);
  EXPECT_EQ(scene.Remaining(), (std::set<int>{1, 2}));
}

TEST(RemoveContinued, RemovesWhatTheTopOfTheImageCutsOff) {
  Scene scene;
  scene.Add({40, 0, 20, 60}, 1, 1);
  EXPECT_TRUE(scene.Remaining().empty());
}

TEST(RemoveContinued, RemovesACornerThatTheMarginOfTheDepthCutsOff) {
  Scene scene;
  scene.Add({115, 10, 35, 30}, 1, 1);
  scene.Forget({0, 0, 160, 10});
  scene.Forget({150, 0, 10, 120});
  EXPECT_TRUE(scene.Remaining().empty());
}

}  // namespace
}  // namespace fovea
