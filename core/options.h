// All options of the method, their profiles, and access to them by name.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/depth/fill_depth_holes.h"
#include "core/depth/flying_pixels.h"
#include "core/depth/normals.h"
#include "core/objects/describe_objects.h"
#include "core/objects/object_choice.h"
#include "core/objects/object_model.h"
#include "core/paper/paper_options.h"
#include "core/saliency/depth_saliency.h"
#include "core/saliency/strength_saliency.h"
#include "core/scene/flat_things.h"
#include "core/scene/gravity.h"
#include "core/scene/region.h"
#include "core/scene/support_surface.h"
#include "core/scene/walls.h"
#include "core/seeds/covering_seeds.h"
#include "core/seeds/saliency_seeds.h"
#include "core/segmentation/mrf_energy.h"
#include "core/segmentation/occlusion_merge.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/gripper.h"
#include "core/types/place.h"

namespace fovea {

// In the order of the pipeline. Units, meanings and sources stand with each stage's options. Stages
// that only profile "default" runs have its values; core/profiles.cc sets those of the others.
struct DetectorOptions {
  // Set: the paper's method runs, with these, and reads nothing else here.
  std::optional<paper::PaperOptions> paper;

  // Once this has passed, the answer is what has been found by then (Detections::incomplete), which
  // differs from run to run. 0: as long as it takes; up to an hour. Of profile "paper" too, which
  // has nothing before its end.
  std::chrono::duration<double, std::milli> time_budget{0};

  double max_depth_m = 3;  // farther away the noise of such cameras is the size of the objects
  RegionOptions region;
  FlyingPixelOptions flying_pixels;
  DepthFillOptions depth_fill;
  NormalOptions normals;
  StrengthSaliencyOptions color_saliency;
  DepthSaliencyOptions depth_saliency;
  SeedOptions seeds;
  GravityOptions gravity;
  SupportOptions support;
  VoxelOptions voxels;
  FlatThingOptions flat_things;
  WallOptions walls;
  CoverOptions cover;
  MrfOptions mrf;
  OcclusionMergeOptions occlusion_merge;
  const ObjectModel* object_model = &FittedObjectModel();  // not null, outlives the options
  ChoiceOptions choice;
  ObjectOptions objects;
  std::vector<Gripper> grippers;      // to plan grasps for; of profile "paper" too
  std::optional<PlaceOptions> place;  // what to find free places for; of profile "paper" too
  PlanningOptions planning;           // of profile "paper" too
};

// "paper": the method as Bao et al. describe it. "default": what goes beyond it. An empty name
// means "default". Throws std::invalid_argument for any other name.
DetectorOptions OptionsOfProfile(std::string_view profile);

// The names of all profiles, the default one first.
std::vector<std::string> ProfileNames();

// One option as people meet it: in requests, on the command line, in the documentation.
struct OptionInfo {
  std::string name;  // for example "mrf.gamma_per_m2"
  double minimum = 0;
  double maximum = 0;
  bool integral = false;    // whole numbers only (a switch is 0 or 1)
  std::string description;  // what it does, its unit and its source
};

// Every option of any profile, in the order of the pipeline.
std::vector<OptionInfo> ListOptions();

// The value by name of each option that the profile of these reads.
std::map<std::string, double> OptionValues(const DetectorOptions& options);

// Whether there is an option of this name, and whether the profile of these reads it.
bool IsOption(std::string_view name);
bool HasOption(const DetectorOptions& options, std::string_view name);

// Sets one option. Throws std::invalid_argument, naming option, value and range, for a name that
// does not exist or that the profile does not read, or a value out of its range.
void SetOption(DetectorOptions& options, std::string_view name, double value);

// Checks every option against its range; throws like SetOption.
void Validate(const DetectorOptions& options);

}  // namespace fovea
