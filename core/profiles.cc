#include <stdexcept>

#include "core/options.h"

namespace fovea {
namespace {

DetectorOptions Paper() {
  DetectorOptions options;
  options.paper.emplace();
  return options;
}

DetectorOptions Default() {
  DetectorOptions options;
  // Here pixels are blocks of those of the camera (core/pixel_blocks.h). Saliency tells what to
  // look at first, and needs few of them.
  options.color_saliency.downscale = 5;
  options.depth_saliency.downscale = 2;
  // Smaller peaks, for seeds where no surface is found: elsewhere they lie all over what is above
  // it.
  options.seeds.disk_radius_px = 5;
  // Any camera pitch.
  options.gravity.num_starts = 4;
  options.gravity.normals.window_radius_px = 5;
  options.gravity.normals.step_px = 3;
  // The surface in the width of the sensor's noise, which grows with the square of the distance.
  options.support.tolerance_m = 0.004;
  options.support.tolerance_per_m = 0.006;
  options.support.tolerance_sigmas = 3.5;
  options.support.common_height_fits = 3;
  // Whole frames: several surfaces, each carrying only what stands within its footprint.
  options.support.max_surfaces = 6;
  options.support.min_area_m2 = 0.05;
  options.support.footprint_margin_m = 0.1;
  options.support.max_height_m = 0.5;
  // Voxels that grow with the distance, as pixels and noise do.
  options.voxels.perspective = true;
  options.voxels.size_m = 0.01;
  options.voxels.neighbor_axes = 1;
  options.voxels.normal_smoothing = 1;
  return options;
}

}  // namespace

DetectorOptions OptionsOfProfile(std::string_view profile) {
  if (profile.empty() || profile == "default") return Default();
  if (profile == "paper") return Paper();
  throw std::invalid_argument("profile: \"" + std::string(profile) +
                              "\" is neither \"default\" nor \"paper\"");
}

std::vector<std::string> ProfileNames() { return {"default", "paper"}; }

}  // namespace fovea
