#include "core/options_table.h"

#include <type_traits>

namespace fovea {
namespace {

using O = DetectorOptions;
using P = paper::PaperOptions;

template <typename Options, typename Locate>
OptionInfo Info(const char* name, double minimum, double maximum, const char* description) {
  constexpr bool kReal = std::is_same_v<std::invoke_result_t<Locate, Options&>, double*>;
  return {name, minimum, maximum, !kReal, description};
}

// Options of profile "default", of profile "paper", and of both, where they are called the same.
template <typename Locate>
OptionEntry OfDefault(const char* name, double minimum, double maximum, const char* description,
                      Locate locate) {
  return {Info<O, Locate>(name, minimum, maximum, description), [locate](O& options) {
            return options.paper ? OptionValue() : OptionValue(locate(options));
          }};
}

template <typename Locate>
OptionEntry OfPaper(const char* name, double minimum, double maximum, const char* description,
                    Locate locate) {
  return {Info<P, Locate>(name, minimum, maximum, description), [locate](O& options) {
            return options.paper ? OptionValue(locate(*options.paper)) : OptionValue();
          }};
}

template <typename Locate>
OptionEntry OfBoth(const char* name, double minimum, double maximum, const char* description,
                   Locate locate) {
  return {Info<O, Locate>(name, minimum, maximum, description), [locate](O& options) {
            return options.paper ? OptionValue(locate(*options.paper))
                                 : OptionValue(locate(options));
          }};
}

}  // namespace

const std::vector<OptionEntry>& OptionTable() {
  static const std::vector<OptionEntry> table = {
      OfBoth("max_depth_m", 0.1, 100, "points farther away are left out; metres",
             [](auto& o) { return &o.max_depth_m; }),

      OfBoth("region.x_px", 0, 10000,
             "region of interest: left; pixels; what it cuts is `truncated`",
             [](auto& o) { return &o.region.x_px; }),
      OfBoth("region.y_px", 0, 10000, "region of interest: top; pixels",
             [](auto& o) { return &o.region.y_px; }),
      OfBoth("region.width_px", 0, 10000, "region of interest: width; pixels; 0: to the end",
             [](auto& o) { return &o.region.width_px; }),
      OfBoth("region.height_px", 0, 10000, "region of interest: height; pixels; 0: to the end",
             [](auto& o) { return &o.region.height_px; }),
      OfBoth("region.min_x_m", -100, 100,
             "workspace in the camera frame; metres; what it cuts is `truncated`",
             [](auto& o) { return &o.region.min_x_m; }),
      OfBoth("region.max_x_m", -100, 100, "workspace in the camera frame; metres",
             [](auto& o) { return &o.region.max_x_m; }),
      OfBoth("region.min_y_m", -100, 100, "workspace in the camera frame; metres",
             [](auto& o) { return &o.region.min_y_m; }),
      OfBoth("region.max_y_m", -100, 100, "workspace in the camera frame; metres",
             [](auto& o) { return &o.region.max_y_m; }),
      OfBoth("region.min_z_m", 0, 100, "workspace in the camera frame; metres",
             [](auto& o) { return &o.region.min_z_m; }),
      OfBoth("region.max_z_m", 0, 100, "workspace in the camera frame; metres",
             [](auto& o) { return &o.region.max_z_m; }),

      OfDefault("flying_pixels.max_angle_deg", 45, 90,
                "surfaces seen at more than this are flying pixels; degrees; 90: none",
                [](O& o) { return &o.flying_pixels.max_angle_deg; }),

      OfBoth("depth_fill.passes", 0, 10, "repetitions of the 5x5 hole filling; paper: unstated",
             [](auto& o) { return &o.depth_fill.passes; }),
      OfPaper("depth_fill.bin_m", 0, 0.1, "width of the interval that the mode is; metres",
              [](P& o) { return &o.depth_fill.bin_m; }),

      OfPaper("normals.window_radius_px", 1, 15, "reach of the window; pixels; Gupta 2013: 3",
              [](P& o) { return &o.normals.window_radius_px; }),
      OfPaper("normals.step_px", 1, 8, "distance of the normals; pixels; Gupta 2013: 1",
              [](P& o) { return &o.normals.step_px; }),
      OfPaper("normals.max_depth_change", 0.001, 0.5,
              "depth step that ends a surface; share of depth",
              [](P& o) { return &o.normals.max_depth_change; }),

      OfPaper("color_saliency.num_scales", 1, 8, "rings of 8s pixels, s = 1 to this; paper: 4",
              [](P& o) { return &o.color_saliency.num_scales; }),
      OfPaper("color_saliency.downscale", 1, 8, "factor that the image is reduced by; paper: 1",
              [](P& o) { return &o.color_saliency.downscale; }),
      OfPaper("color_saliency.stretch", 0, 1,
              "1: MaxDist is the span of a channel in this image; 0: its whole span, 255",
              [](P& o) { return &o.color_saliency.stretch; }),

      OfPaper("depth_saliency.downscale", 1, 8, "factor that the depth image is reduced by; Ju: 1",
              [](P& o) { return &o.depth_saliency.downscale; }),
      OfPaper("depth_saliency.superpixels_per_diagonal", 0, 4,
              "superpixels per pixel of the image diagonal; 0: every pixel; Ju 2014: 1",
              [](P& o) { return &o.superpixels_per_diagonal; }),
      OfPaper("depth_saliency.line_length", 0.05, 1,
              "length of the scan lines; share of the image diagonal; Ju 2014: 0.4",
              [](P& o) { return &o.depth_saliency.line_length; }),
      OfPaper("depth_saliency.line_step_px", 1, 32, "distance of samples; pixels; Ju 2014: 5",
              [](P& o) { return &o.depth_saliency.line_step_px; }),
      OfPaper("depth_saliency.depth_prior", 0, 1, "1 weights the farther half down; Ju 2014: 1",
              [](P& o) { return &o.depth_saliency.depth_prior; }),
      OfPaper("depth_saliency.center_prior", 0, 1, "1 weights the image border down; Ju 2014: 1",
              [](P& o) { return &o.depth_saliency.center_prior; }),

      OfBoth("seeds.disk_radius_px", 0, 100,
             "disk of the opening by reconstruction; pixels at a width of 640; paper: 20",
             [](auto& o) { return &o.seeds.disk_radius_px; }),
      OfPaper("seeds.on_peak", 0, 1, "1 moves a seed to the nearest measured pixel of its peak",
              [](P& o) { return &o.seeds.on_peak; }),
      OfPaper("seeds.drop_below", 0, 1, "1 removes seeds below the support, as those on it",
              [](P& o) { return &o.support_reading.removes_seeds_below; }),
      OfBoth("seeds.from_color", 0, 1, "1: colour saliency gives seeds; paper: 1",
             [](auto& o) { return &o.seeds.from_color; }),
      OfBoth("seeds.from_depth", 0, 1, "1: depth saliency gives seeds; paper: 1",
             [](auto& o) { return &o.seeds.from_depth; }),

      OfPaper("gravity.coarse_angle_deg", 1, 45, "gate of the first stage; degrees; Gupta 2013: 45",
              [](P& o) { return &o.gravity.coarse_angle_deg; }),
      OfPaper("gravity.fine_angle_deg", 1, 45, "gate of the second stage; degrees; Gupta 2013: 15",
              [](P& o) { return &o.gravity.fine_angle_deg; }),
      OfPaper("gravity.iterations", 0, 100, "of each stage; Gupta 2013: 5",
              [](P& o) { return &o.gravity.iterations; }),
      OfPaper("gravity.window_radius_px", 1, 15, "reach of the normals' window; Gupta 2013: 10",
              [](P& o) { return &o.gravity.normals.window_radius_px; }),
      OfPaper("gravity.sample_px", 1, 4, "distance of the window's pixels; Gupta 2013: 1",
              [](P& o) { return &o.gravity.normals.sample_px; }),
      OfPaper("gravity.step_px", 1, 64, "distance of the normals used; pixels",
              [](P& o) { return &o.gravity.normals.step_px; }),
      OfPaper("gravity.num_starts", 1, 9, "camera pitches it starts from; Gupta 2013: 1",
              [](P& o) { return &o.gravity.num_starts; }),

      OfPaper("support.max_angle_deg", 1, 90,
              "how far from vertical a support normal may be; degrees",
              [](P& o) { return &o.support.max_angle_deg; }),
      OfPaper("support.height_bin_m", 0.001, 0.2, "interval of the height histogram; metres",
              [](P& o) { return &o.support.height_bin_m; }),
      OfBoth("support.tolerance_m", 0.001, 0.2, "distance that still counts as surface; metres",
             [](auto& o) { return &o.support.tolerance_m; }),
      OfPaper("support.plane_fits", 0, 20, "least-squares refinements; 0: perpendicular to gravity",
              [](P& o) { return &o.support.plane_fits; }),
      OfBoth("support.min_share", 0, 1, "fewer of all points make no surface; share",
             [](auto& o) { return &o.support.min_share; }),
      OfPaper(
          "support.hard", 0, 1,
          "what \"probability one\" of the background means on the support; 0: costs it nothing; "
          "1: it, and all below, can be nothing else",
          [](P& o) { return &o.support_reading.hard; }),
      OfPaper("support.with_below", 0, 1, "1: the same for what lies below the support",
              [](P& o) { return &o.support_reading.includes_below; }),
      OfDefault("support.max_surfaces", 1, 16, "surfaces that are looked for; paper: 1",
                [](O& o) { return &o.support.max_surfaces; }),
      OfDefault("support.min_area_m2", 0, 10,
                "visible area below which a surface carries nothing; m2",
                [](O& o) { return &o.support.min_area_m2; }),
      OfDefault("support.footprint_margin_m", 0, 2,
                "how far beside a surface things may stand; metres; 0: anywhere; paper: 0",
                [](O& o) { return &o.support.footprint_margin_m; }),
      OfDefault("support.max_height_m", 0.05, 100,
                "points higher above every surface belong to no object; metres",
                [](O& o) { return &o.support.max_height_m; }),

      OfBoth("voxels.size_m", 0.003, 0.1, "edge length; metres",
             [](auto& o) { return &o.voxels.size_m; }),
      OfPaper("voxels.neighbor_axes", 1, 3, "1, 2, 3: 6, 18 or 26 neighbours",
              [](P& o) { return &o.voxels.neighbor_axes; }),

      OfDefault("flat_things.min_contrast", 0, 255,
                "colour by which flat things differ from what they lie on; 0: no search; paper: 0",
                [](O& o) { return &o.flat_things.min_contrast; }),
      OfDefault("walls.min_extent_m", 0, 10,
                "upright planes at least this long are wall; metres; 0: no search; paper: 0",
                [](O& o) { return &o.walls.min_extent_m; }),

      OfDefault("cover.spacing_m", 0, 1,
                "farthest a voxel may be from a seed; metres; 0: any; paper: 0",
                [](O& o) { return &o.cover.spacing_m; }),

      OfBoth("mrf.gamma_per_m2", 0.1, 10000, "Eq. 5: fading of a hypothesis; 1/m2; paper: 180",
             [](auto& o) { return &o.mrf.data.gamma_per_m2; }),
      OfBoth("mrf.alpha", 1e-6, 1, "Eq. 6: weight of the background; paper: 0.1",
             [](auto& o) { return &o.mrf.data.alpha; }),
      OfBoth("mrf.lambda", 0, 1000, "weight of the pairwise term, Eq. 7; paper: unstated",
             [](auto& o) { return &o.mrf.lambda; }),
      OfPaper("mrf.epsilon", 0, 10, "Eq. 7: share of it at concave transitions; paper: unstated",
              [](P& o) { return &o.mrf.epsilon; }),
      OfPaper("mrf.normal_constant", 1e-3, 10, "Eq. 7: added to the distance of normals",
              [](P& o) { return &o.mrf.normal_constant; }),
      OfDefault("mrf.concave_angle_deg", 0.1, 90,
                "concave angle at which the pairwise term falls to 1/e; degrees",
                [](O& o) { return &o.mrf.concave_angle_deg; }),
      OfDefault("mrf.color_floor", 0, 1,
                "share of the weight left between voxels of different colours; paper: 1",
                [](O& o) { return &o.mrf.color_floor; }),
      OfPaper("mrf.min_probability", 1e-30, 0.1, "floor of the probabilities of Eq. 5 and 6",
              [](P& o) { return &o.mrf.data.min_probability; }),
      OfPaper("mrf.max_sweeps", 1, 100, "of alpha-expansion",
              [](P& o) { return &o.mrf.max_sweeps; }),
      OfDefault("mrf.cluster_voxels", 1, 64, "that are labelled together; 1: each alone; paper: 1",
                [](O& o) { return &o.mrf.cluster_voxels; }),

      OfPaper("color_merge.min_correlation", -1, 1, "that joins neighbours; 1: never; paper: 0.5",
              [](P& o) { return &o.color_merge.min_correlation; }),
      OfPaper("color_merge.bins", 2, 32, "of each RGB channel; paper: 20",
              [](P& o) { return &o.color_merge.bins; }),
      OfPaper("color_merge.split", 0, 1, "1 compares the connected parts of labels",
              [](P& o) { return &o.color_merge.split; }),
      OfPaper("color_merge.iterate", 0, 1, "1 compares again what was joined, until nothing is",
              [](P& o) { return &o.color_merge.iterate; }),

      OfDefault("occlusion_merge.min_shared_surface", 0, 1,
                "parts behind an occluder that share this much surface are one; 0: never; paper: 0",
                [](O& o) { return &o.occlusion_merge.min_shared_surface; }),
      OfDefault("occlusion_merge.min_hollow_curvature_per_m", 0, 1000,
                "mean inward curvature that makes an inside; 1/m; 0: never; paper: 0",
                [](O& o) { return &o.occlusion_merge.min_hollow_curvature_per_m; }),

      OfDefault("objects.min_probability", 0, 1, "what is less likely an object is not reported",
                [](O& o) { return &o.choice.min_probability; }),
      OfBoth("objects.max_objects", 0, 10000,
             "the most salient ones that are kept, as if nothing else were there; 0: all",
             [](auto& o) { return &o.objects.selection.max_objects; }),
      OfBoth("objects.min_pixels", 0, 100000, "smaller objects are dropped; pixels at 640x480",
             [](auto& o) { return &o.objects.selection.min_pixels; }),
      OfBoth("objects.box.max_gap_m", 0, 1, "a box ends at a support this close; metres",
             [](auto& o) { return &o.objects.box.max_gap_m; }),
  };
  return table;
}

}  // namespace fovea
