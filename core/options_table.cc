#include "core/options_table.h"

#include <type_traits>

namespace fovea {
namespace {

using O = DetectorOptions;

template <typename Locate>
OptionEntry Entry(const char* name, double minimum, double maximum, const char* description,
                  Locate locate) {
  constexpr bool kReal = std::is_same_v<std::invoke_result_t<Locate, O&>, double*>;
  return {{name, minimum, maximum, !kReal, description}, locate};
}

}  // namespace

const std::vector<OptionEntry>& OptionTable() {
  static const std::vector<OptionEntry> table = {
      Entry("max_depth_m", 0.1, 100, "points farther away are left out; metres",
            [](O& o) { return &o.max_depth_m; }),

      Entry("region.x_px", 0, 10000, "region of interest: left; pixels",
            [](O& o) { return &o.region.x_px; }),
      Entry("region.y_px", 0, 10000, "region of interest: top; pixels",
            [](O& o) { return &o.region.y_px; }),
      Entry("region.width_px", 0, 10000, "region of interest: width; pixels; 0: to the end",
            [](O& o) { return &o.region.width_px; }),
      Entry("region.height_px", 0, 10000, "region of interest: height; pixels; 0: to the end",
            [](O& o) { return &o.region.height_px; }),
      Entry("region.min_x_m", -100, 100, "workspace in the camera frame; metres",
            [](O& o) { return &o.region.min_x_m; }),
      Entry("region.max_x_m", -100, 100, "workspace in the camera frame; metres",
            [](O& o) { return &o.region.max_x_m; }),
      Entry("region.min_y_m", -100, 100, "workspace in the camera frame; metres",
            [](O& o) { return &o.region.min_y_m; }),
      Entry("region.max_y_m", -100, 100, "workspace in the camera frame; metres",
            [](O& o) { return &o.region.max_y_m; }),
      Entry("region.min_z_m", 0, 100, "workspace in the camera frame; metres",
            [](O& o) { return &o.region.min_z_m; }),
      Entry("region.max_z_m", 0, 100, "workspace in the camera frame; metres",
            [](O& o) { return &o.region.max_z_m; }),

      Entry("depth_fill.passes", 0, 10, "repetitions of the 5x5 hole filling; paper: unstated",
            [](O& o) { return &o.depth_fill.passes; }),
      Entry("depth_fill.bin_m", 0, 0.1, "width of the interval that the mode is; metres",
            [](O& o) { return &o.depth_fill.bin_m; }),

      Entry("normals.window_radius_px", 1, 15, "reach of the window; pixels; Gupta 2013: 3",
            [](O& o) { return &o.normals.window_radius_px; }),
      Entry("normals.max_depth_change", 0.001, 0.5,
            "depth step that ends a surface; share of depth",
            [](O& o) { return &o.normals.max_depth_change; }),

      Entry("color_saliency.num_scales", 1, 8, "rings of 8s pixels, s = 1 to this; paper: 4",
            [](O& o) { return &o.color_saliency.num_scales; }),
      Entry("color_saliency.downscale", 1, 8, "factor that the image is reduced by; paper: 1",
            [](O& o) { return &o.color_saliency.downscale; }),

      Entry("depth_saliency.superpixels_per_diagonal", 0, 4,
            "superpixels per pixel of the image diagonal; 0: every pixel; Ju 2014: 1",
            [](O& o) { return &o.depth_saliency.superpixels_per_diagonal; }),
      Entry("depth_saliency.line_length", 0.05, 1,
            "length of the scan lines; share of the image diagonal; Ju 2014: 0.4",
            [](O& o) { return &o.depth_saliency.line_length; }),
      Entry("depth_saliency.line_step_px", 1, 32, "distance of samples; pixels; Ju 2014: 5",
            [](O& o) { return &o.depth_saliency.line_step_px; }),
      Entry("depth_saliency.depth_prior", 0, 1, "1 weights the farther half down; Ju 2014: 1",
            [](O& o) { return &o.depth_saliency.depth_prior; }),
      Entry("depth_saliency.center_prior", 0, 1, "1 weights the image border down; Ju 2014: 1",
            [](O& o) { return &o.depth_saliency.center_prior; }),

      Entry("seeds.disk_radius_px", 0, 100,
            "disk of the opening by reconstruction; pixels at a width of 640; paper: 20",
            [](O& o) { return &o.seeds.disk_radius_px; }),
      Entry("seeds.on_peak", 0, 1, "1 moves a seed to the nearest measured pixel of its peak",
            [](O& o) { return &o.seeds.on_peak; }),

      Entry("gravity.coarse_angle_deg", 1, 45, "gate of the first stage; degrees; Gupta 2013: 45",
            [](O& o) { return &o.gravity.coarse_angle_deg; }),
      Entry("gravity.fine_angle_deg", 1, 45, "gate of the second stage; degrees; Gupta 2013: 15",
            [](O& o) { return &o.gravity.fine_angle_deg; }),
      Entry("gravity.iterations", 0, 100, "of each stage; Gupta 2013: 5",
            [](O& o) { return &o.gravity.iterations; }),
      Entry("gravity.window_radius_px", 1, 15, "reach of the normals' window; Gupta 2013: 10",
            [](O& o) { return &o.gravity.window_radius_px; }),
      Entry("gravity.step_px", 1, 64, "distance of the normals used; pixels",
            [](O& o) { return &o.gravity.step_px; }),

      Entry("gravity.num_starts", 1, 9, "camera pitches it starts from; Gupta 2013: 1",
            [](O& o) { return &o.gravity.num_starts; }),

      Entry("support.wide_normals", 0, 1, "1: normals of gravity's windows; paper: 0",
            [](O& o) { return &o.support.wide_normals; }),
      Entry("support.max_angle_deg", 1, 90,
            "how far from vertical a support normal may be; degrees",
            [](O& o) { return &o.support.max_angle_deg; }),
      Entry("support.height_bin_m", 0.001, 0.2, "interval of the height histogram; metres",
            [](O& o) { return &o.support.height_bin_m; }),
      Entry("support.tolerance_m", 0.001, 0.2, "distance that still counts as surface; metres",
            [](O& o) { return &o.support.tolerance_m; }),
      Entry("support.tolerance_per_m", 0, 0.1, "what is added to it per square metre of distance",
            [](O& o) { return &o.support.tolerance_per_m; }),
      Entry("support.plane_fits", 0, 20, "least-squares refinements; 0: perpendicular to gravity",
            [](O& o) { return &o.support.plane_fits; }),
      Entry("support.min_share", 0, 1, "fewer of all points make no surface; share",
            [](O& o) { return &o.support.min_share; }),

      Entry("support.max_surfaces", 1, 16, "surfaces that are looked for; paper: 1",
            [](O& o) { return &o.support.max_surfaces; }),
      Entry("support.min_area_m2", 0, 10, "visible area below which a surface carries nothing; m2",
            [](O& o) { return &o.support.min_area_m2; }),
      Entry("support.footprint_margin_m", 0, 2,
            "how far beside a surface things may stand; metres; 0: anywhere; paper: 0",
            [](O& o) { return &o.support.footprint_margin_m; }),
      Entry("support.max_height_m", 0.05, 100,
            "points higher above every surface belong to no object; metres",
            [](O& o) { return &o.support.max_height_m; }),

      Entry("voxels.perspective", 0, 1,
            "1: voxels grow with the distance, size_m is theirs at 1 m; paper: 0",
            [](O& o) { return &o.voxels.perspective; }),
      Entry("voxels.size_m", 0.003, 0.1, "edge length; metres",
            [](O& o) { return &o.voxels.size_m; }),
      Entry("voxels.neighbor_axes", 1, 3, "1, 2, 3: 6, 18 or 26 neighbours",
            [](O& o) { return &o.voxels.neighbor_axes; }),

      Entry("voxels.normal_smoothing", 0, 5, "passes of averaging a normal with its neighbours'",
            [](O& o) { return &o.voxels.normal_smoothing; }),

      Entry("walls.min_extent_m", 0, 10,
            "upright planes at least this long are wall; metres; 0: no search; paper: 0",
            [](O& o) { return &o.walls.min_extent_m; }),
      Entry("walls.min_area_m2", 0, 10, "and of at least this visible area; m2",
            [](O& o) { return &o.walls.min_area_m2; }),
      Entry("walls.max_planes", 1, 32, "upright planes that are looked for",
            [](O& o) { return &o.walls.max_planes; }),

      Entry("cover.spacing_m", 0, 1,
            "farthest a voxel may be from a seed; metres; 0: any; paper: 0",
            [](O& o) { return &o.cover.spacing_m; }),
      Entry("cover.min_voxels", 1, 10000, "connected parts with fewer get no seed of their own",
            [](O& o) { return &o.cover.min_voxels; }),

      Entry("cover.max_extent_m", 0.05, 100, "longer parts, walls, get none either; metres",
            [](O& o) { return &o.cover.max_extent_m; }),

      Entry("mrf.gamma_per_m2", 0.1, 10000, "Eq. 5: fading of a hypothesis; 1/m2; paper: 180",
            [](O& o) { return &o.mrf.gamma_per_m2; }),
      Entry("mrf.alpha", 1e-6, 1, "Eq. 6: weight of the background; paper: 0.1",
            [](O& o) { return &o.mrf.alpha; }),
      Entry("mrf.lambda", 0, 1000, "Eq. 7: weight of the pairwise term",
            [](O& o) { return &o.mrf.lambda; }),
      Entry("mrf.epsilon", 0, 10, "Eq. 7: share of it at concave transitions",
            [](O& o) { return &o.mrf.epsilon; }),
      Entry("mrf.normal_constant", 1e-3, 10, "Eq. 7: added to the distance of normals",
            [](O& o) { return &o.mrf.normal_constant; }),
      Entry("mrf.concave_angle_deg", 0, 90,
            "0: weights of Eq. 7; else the concave angle at which they fall to 1/e; degrees",
            [](O& o) { return &o.mrf.concave_angle_deg; }),
      Entry("mrf.min_probability", 1e-30, 0.1, "floor of the probabilities of Eq. 5 and 6",
            [](O& o) { return &o.mrf.min_probability; }),
      Entry("mrf.reach_m", 0.05, 100, "a hypothesis is no choice for voxels farther off; metres",
            [](O& o) { return &o.mrf.reach_m; }),
      Entry("mrf.max_sweeps", 1, 100, "of alpha-expansion", [](O& o) { return &o.mrf.max_sweeps; }),

      Entry("mrf.cluster_voxels", 1, 64, "that are labelled together; 1: each alone; paper: 1",
            [](O& o) { return &o.mrf.cluster_voxels; }),
      Entry("mrf.cluster_min_share", 0, 1, "of lambda that ties voxels to each other",
            [](O& o) { return &o.mrf.cluster_min_share; }),

      Entry("color_merge.min_correlation", -1, 1, "that joins neighbours; 1: never; paper: 0.5",
            [](O& o) { return &o.color_merge.min_correlation; }),
      Entry("color_merge.bins", 2, 32, "of each RGB channel; paper: 20",
            [](O& o) { return &o.color_merge.bins; }),

      Entry("shape_merge.max_concavity_deg", 0, 90,
            "mean concavity of a boundary that still joins; degrees; 0: never; paper: 0",
            [](O& o) { return &o.shape_merge.max_concavity_deg; }),
      Entry("shape_merge.color_weight_deg", 0, 10, "degrees taken off for each unit of CIELAB",
            [](O& o) { return &o.shape_merge.color_weight_deg; }),
      Entry("shape_merge.reach_cells", 1, 4, "voxels this many cells apart share a boundary",
            [](O& o) { return &o.shape_merge.reach_cells; }),
      Entry("shape_merge.min_pairs", 1, 10000, "pairs of voxels that make a boundary",
            [](O& o) { return &o.shape_merge.min_pairs; }),

      Entry("occlusion_merge.min_shared_surface", 0, 1,
            "parts behind an occluder that share this much surface are one; 0: never; paper: 0",
            [](O& o) { return &o.occlusion_merge.min_shared_surface; }),
      Entry("occlusion_merge.max_angle_deg", 1, 90, "between normals of one surface; degrees",
            [](O& o) { return &o.occlusion_merge.max_angle_deg; }),
      Entry("occlusion_merge.max_offset_m", 0.001, 0.1, "from each other's tangent plane; metres",
            [](O& o) { return &o.occlusion_merge.max_offset_m; }),
      Entry("occlusion_merge.max_color_distance", 0, 200, "of mean colours; CIELAB units",
            [](O& o) { return &o.occlusion_merge.max_color_distance; }),
      Entry("occlusion_merge.max_seen_through", 0, 1,
            "share of what lies between the parts that shows something farther away",
            [](O& o) { return &o.occlusion_merge.max_seen_through; }),
      Entry("occlusion_merge.min_hollow_curvature_per_m", 0, 1000,
            "mean inward curvature that makes an inside; 1/m; 0: never; paper: 0",
            [](O& o) { return &o.occlusion_merge.min_hollow_curvature_per_m; }),
      Entry("occlusion_merge.max_rim_step_m", 0, 1,
            "between the tops of inside and outside; metres",
            [](O& o) { return &o.occlusion_merge.max_rim_step_m; }),

      Entry("plausibility.max_size_m", 0.05, 100, "longer segments are no objects; metres",
            [](O& o) { return &o.plausibility.max_size_m; }),
      Entry("plausibility.max_hang_m", 0, 10,
            "segments this close below a surface are its edge; metres",
            [](O& o) { return &o.plausibility.max_hang_m; }),
      Entry("plausibility.max_height_m", 0.05, 100, "taller segments are no objects; metres",
            [](O& o) { return &o.plausibility.max_height_m; }),
      Entry("plausibility.max_rest_m", 0.005, 100,
            "segments higher above their surface must touch another; metres",
            [](O& o) { return &o.plausibility.max_rest_m; }),

      Entry("continuation.max_share", 0, 1,
            "of an outline that ends at larger things or with the image; 1: any; paper: 1",
            [](O& o) { return &o.continuation.max_share; }),

      Entry("objects.min_area_m2", 0, 1,
            "smaller objects are dropped; area as seen from the camera; m2; paper: 0",
            [](O& o) { return &o.objects.min_area_m2; }),
      Entry("objects.max_objects", 0, 10000, "the most salient ones that are kept; 0: all",
            [](O& o) { return &o.objects.max_objects; }),
      Entry("objects.min_pixels", 0, 100000, "smaller objects are dropped; pixels at 640x480",
            [](O& o) { return &o.objects.min_pixels; }),
      Entry("objects.box.max_gap_m", 0, 1, "a box reaches down to a support this close; metres",
            [](O& o) { return &o.objects.box.max_gap_m; }),
      Entry("objects.grasp.finger_depth_m", 0, 0.2, "reach of the fingers below the top; metres",
            [](O& o) { return &o.objects.grasp.finger_depth_m; }),
  };
  return table;
}

}  // namespace fovea
