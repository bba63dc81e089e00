// Noise in every pixel is what takes longest: each of its stages can be stopped in its midst, and
// what is beyond the limits is refused in words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <opencv2/core.hpp>
#include <vector>

#include "core/depth/back_projection.h"
#include "core/detector.h"
#include "core/objects/labelled_scene.h"
#include "core/refinement.h"
#include "core/scene/flat_things.h"
#include "core/seeds/salient_positions.h"
#include "core/segmentation/alpha_expansion.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"
#include "core/types/lab.h"
#include "core/types/too_complex.h"

namespace fovea {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

RgbdFrame Noise(const cv::Size& size) {
  const double focal_px = 525.0 * size.width / 640;
  RgbdFrame noise{cv::Mat(size, CV_8UC3),
                  cv::Mat(size, CV_32FC1),
                  {focal_px, focal_px, size.width / 2.0, size.height / 2.0},
                  {}};
  cv::RNG random(1);
  random.fill(noise.color_rgb, cv::RNG::UNIFORM, 0, 256);
  random.fill(noise.depth_m, cv::RNG::UNIFORM, 0.3, 4);
  return noise;
}

// How often something asks whether to stop; told to at the last of `most`.
int Polls(const std::function<void()>& work, int most = -1) {
  int polls = 0;
  const InterruptionScope scope([&] { return ++polls == most; }, std::chrono::microseconds(0));
  work();
  return polls;
}

void ExpectToStop(const char* stage, int min_polls, const std::function<void()>& work) {
  SCOPED_TRACE(stage);
  const int polls = Polls(work);
  EXPECT_GE(polls, min_polls);
  EXPECT_THROW(Polls(work, polls / 2), Cancelled);
  work();  // for the stages that follow
}

// In the order of the pipeline, each with what those before it made.
TEST(Noise, CanBeStoppedInEachStage) {
  const RgbdFrame frame = Noise({160, 120});
  const DetectorOptions options = OptionsOfProfile("default");
  constexpr int kRows = 120;
  cv::Mat depth, points, color_saliency, depth_saliency;
  ExpectToStop("depth", kRows, [&] {
    depth = FillDepthHoles(RemoveFlyingPixels(frame.depth_m, 130, 130, options.flying_pixels),
                           options.depth_fill);
    points = BackProject(depth, frame.intrinsics, options.max_depth_m);
  });
  NormalMap normals;
  ExpectToStop("normals", kRows,
               [&] { normals = EstimateNormals(points, frame.intrinsics, options.normals); });
  ExpectToStop("color_saliency", 2 * 12,  // maps
               [&] { color_saliency = StrengthSaliency(frame.color_rgb, options.color_saliency); });
  ExpectToStop("depth_saliency", 60,
               [&] { depth_saliency = DepthSaliency(depth, options.depth_saliency); });
  Diagnostics counts;
  std::vector<Seed> seeds;
  ExpectToStop("seeds", 4 * kRows, [&] {
    seeds = FindSalientPositions(color_saliency, options.color_saliency.downscale, depth_saliency,
                                 options.depth_saliency.downscale, points, options.seeds, counts)
                .seeds;
  });
  const Eigen::Vector3f down = Eigen::Vector3f::UnitY();
  std::vector<Support> supports;
  ExpectToStop("support", kRows, [&] {
    EstimateGravity(normals.vectors, options.gravity);
    supports = FindSupports(points, normals, down, options.support);
  });
  VoxelGrid grid;
  const cv::Mat lab = LabOf(frame.color_rgb);
  std::vector<MeanColor> colors;
  std::vector<char> on_wall;
  const std::size_t num_salient = seeds.size();
  ExpectToStop("voxels", 4 * kRows, [&] {
    grid = BuildVoxelGrid(points, normals, options.voxels);
    const std::vector<char> nowhere(grid.voxels.size(), 0);
    const std::vector<char> everywhere(grid.voxels.size(), 1);
    colors = ColorsOfVoxels(grid, lab);
    FindFlatThings(grid, colors, everywhere, supports, options.support, options.flat_things);
    on_wall = FindWalls(grid, -down, supports, options.support, options.walls);
    seeds.resize(num_salient);
    seeds = CoverWithSeeds(grid, nowhere, seeds, options.cover);
  });
  const std::vector<char> is_background(grid.voxels.size(), 0);
  ClusteredEnergy clustered;
  ExpectToStop("energy", static_cast<int>(seeds.size()),
               [&] { clustered = BuildEnergy(grid, colors, is_background, seeds, options.mrf); });
  std::vector<int> labels;
  ExpectToStop("graph_cut", static_cast<int>(seeds.size()), [&] {
    labels = LabelsOfNodes(clustered.clusters, MinimizeByAlphaExpansion(clustered.energy, 1));
  });
  const cv::Mat standing = cv::Mat::zeros(depth.size(), CV_8UC1);
  const LabelledScene scene{grid,  labels,   points,   lab,     colors,      frame.intrinsics,
                            -down, supports, standing, on_wall, frame.unseen};
  ExpectToStop("refinement", 40 * kRows, [&] { Refine(scene, options); });
}

TEST(Noise, IsCalledNoise) {
  const RgbdFrame frame = Noise({160, 120});
  const Diagnostics found = Detect(frame, OptionsOfProfile("default")).diagnostics;
  EXPECT_EQ(found.num_too_far, static_cast<std::size_t>(cv::countNonZero(frame.depth_m > 3)));
  EXPECT_LT(2 * found.num_points, found.num_measured);
  EXPECT_THAT(found.messages, Contains(HasSubstr("mostly noise")));
}

TEST(Noise, WithMoreSegmentsThanAnImageHoldsIsRefused) {
  std::vector<int> segments(65536);
  for (int i = 0; i < 65536; ++i) segments[i] = i;
  EXPECT_NO_THROW(RequireFewSegments(segments));
  segments.push_back(65536);
  EXPECT_THAT([&] { RequireFewSegments(segments); },
              ThrowsMessage<TooComplex>(HasSubstr("raise voxels.size_m")));
}

TEST(Noise, WithMoreHypothesesThanMemoryShouldHoldIsRefused) {
  constexpr std::size_t kNum = 10'000;
  const Eigen::Vector3f place(0, 0, 2);
  const Sites sites{std::vector<Eigen::Vector3f>(kNum, place), std::vector<float>(kNum, 0),
                    std::vector<float>(kNum, 1)};
  const std::vector<Seed> seeds((std::size_t{1} << 25U) / kNum + 1, Seed{{}, place});
  EXPECT_THAT([&] { DataTerm(sites, seeds, {.gamma_per_m2 = 0.1}); },
              ThrowsMessage<TooComplex>(HasSubstr("raise mrf.gamma_per_m2")));
}

}  // namespace
}  // namespace fovea
