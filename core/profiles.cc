#include <stdexcept>

#include "core/options.h"

namespace fovea {
namespace {

// The initial values of the options' structs are the paper's.
DetectorOptions Paper() { return {}; }

DetectorOptions Default() {
  DetectorOptions options;
  // A quarter of the resolution finds the same objects at a twentieth of the cost.
  options.color_saliency.downscale = 4;
  options.depth_saliency.superpixels_per_diagonal = 0;
  // Smaller peaks, and seeds wherever something above the support has none.
  options.seeds.disk_radius_px = 5;
  options.cover.spacing_m = 0.05;
  // The surface in the width of the sensor's noise, which grows with the square of the distance.
  options.support.tolerance_m = 0.004;
  options.support.tolerance_per_m = 0.006;
  // With dense seeds, hypotheses may reach across an object; grooves part the objects.
  options.voxels.size_m = 0.008;
  options.voxels.neighbor_axes = 1;
  options.voxels.normal_smoothing = 1;
  options.mrf.gamma_per_m2 = 30;
  options.mrf.lambda = 8;
  options.mrf.concave_angle_deg = 12;
  // Shape joins the parts of an object; textures would part them, so colour only adds to it.
  options.color_merge.min_correlation = 1;
  options.shape_merge.max_concavity_deg = 12;
  options.shape_merge.color_weight_deg = 0.4;
  options.shape_merge.reach_cells = 1;
  options.objects.min_pixels = 500;
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
