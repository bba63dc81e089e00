#include "core/scene_geometry.h"

#include "core/depth/normals.h"
#include "core/scene/background.h"
#include "core/scene/flat_things.h"
#include "core/scene/missing_depth.h"
#include "core/scene/walls.h"
#include "core/types/helpers.h"
#include "core/types/lab.h"

namespace fovea {
namespace {

void AddFlatThings(const std::vector<char>& is_flat_thing, const CameraIntrinsics& intrinsics,
                   const RegionOptions& region, SceneGeometry& scene) {
  for (std::size_t v = 0; v < is_flat_thing.size(); ++v) {
    if (is_flat_thing[v] == 0) continue;
    if (IsInRegion(scene.grid.voxels[v].mean, intrinsics, region)) {
      scene.is_background[v] = 0;
    } else {
      scene.hidden[v] = 1;
    }
  }
}

// What is background but for walls, and the colours by which flat things are told from it.
void SetThings(const CameraIntrinsics& camera, const DetectorOptions& options,
               SceneGeometry& scene) {
  scene.is_background =
      FindBackground(scene.grid, scene.supports, options.support, camera, options.region);
  scene.hidden =
      FindHiddenByRegion(scene.grid, scene.supports, options.support, camera, options.region);
  scene.colors = ColorsOfVoxels(scene.grid, scene.lab);
  AddFlatThings(FindFlatThings(scene.grid, scene.colors, scene.is_background, scene.supports,
                               options.support, options.flat_things),
                camera, options.region, scene);
}

void AddWalls(SceneGeometry& scene) {
  const std::vector<char>& on_wall = scene.on_wall;
  for (std::size_t v = 0; v < on_wall.size(); ++v) scene.is_background[v] |= on_wall[v];
  for (std::size_t v = 0; v < scene.hidden.size(); ++v) scene.hidden[v] &= on_wall[v] == 0 ? 1 : 0;
}

}  // namespace

SceneGeometry FindGeometry(const RgbdFrame& frame, const cv::Mat& depth_m, const cv::Mat& points,
                           const CameraIntrinsics& camera, const DetectorOptions& options,
                           StageClock& clock) {
  SceneGeometry scene;
  scene.points = points;
  // The wide ones of wide windows, which noise far away tilts less than every pixel's.
  NormalMap normals, wide_normals;
  RunTogether(
      {[&] { normals = EstimateNormals(points, frame.intrinsics, options.normals); },
       [&] { wide_normals = EstimateNormals(points, frame.intrinsics, options.gravity.normals); }});
  clock.Begin("support");

  scene.gravity = FindGravity(frame.gravity, wide_normals.vectors, options.gravity);
  scene.supports = FindSupports(points, wide_normals, scene.gravity.direction, options.support);
  // What cannot be measured leaves a hole in its support.
  scene.standing =
      StandInForMissing(depth_m, scene.supports, frame.intrinsics,
                        {options.support.max_height_m, options.max_depth_m}, scene.points, normals);
  clock.Begin("voxels");

  RunTogether({[&] { scene.grid = BuildVoxelGrid(scene.points, normals, options.voxels); },
               [&] { scene.lab = LabOf(frame.color_rgb); }});
  RunTogether({[&] { SetThings(camera, options, scene); },
               [&] {
                 scene.on_wall = FindWalls(scene.grid, -scene.gravity.direction, scene.supports,
                                           options.support, options.walls);
               }});
  AddWalls(scene);
  return scene;
}

}  // namespace fovea
