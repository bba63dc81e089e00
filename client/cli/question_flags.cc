#include "client/cli/question_flags.h"

#include <CLI/CLI.hpp>

#include "flags/finite_range.h"

namespace fovea::cli {
namespace {

void AddMethodFlags(CLI::App& command, QuestionFlags& flags, const char* group) {
  command.add_option("--profile", flags.profile, "Settings to start from: default or paper")
      ->type_name("NAME")
      ->group(group);
  command.add_option("--set", flags.settings, "Changes one option; may be repeated")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false)
      ->group(group);
  command
      .add_option("--time-budget", flags.time_budget_s,
                  "Longest detection: what is most salient is looked at first, and the answer is "
                  "what has been found by then; 0 = as long as it takes")
      ->type_name("SECONDS")
      ->check(flags::FiniteRange(0, 3600))
      ->group(group);
}

void AddHandFlags(CLI::App& command, QuestionFlags& flags, const char* group) {
  command
      .add_option("--gripper", flags.grippers,
                  "Plan grasps for: jaw=OPENING, suction=DIAMETER (metres), a fovea.v1.Gripper in "
                  "JSON, or none; may be repeated; jaw=0.085 unless given. LEAST: of the "
                  "probabilities to hold that are returned, 0.5 unless given")
      ->type_name("KIND=METRES[,LEAST]|{...}")
      ->allow_extra_args(false)
      ->group(group);
  CLI::Option* const place = command
                                 .add_option("--place", flags.place,
                                             "Find free places for something of this size (metres)")
                                 ->type_name("LENGTH,WIDTH,HEIGHT")
                                 ->group(group);
  command
      .add_option("--place-margin", flags.place_margin_m,
                  "Keep as much free around it, and to edges and what is unseen; 0.02 unless given")
      ->type_name("METRES")
      ->check(flags::FiniteRange(0, 1))
      ->needs(place)
      ->group(group);
  command.add_option("--max-places", flags.max_places, "Places at most; 5 unless given")
      ->type_name("N")
      ->check(CLI::Range(1, 100))
      ->needs(place)
      ->group(group);
}

void AddPlanningFlags(CLI::App& command, QuestionFlags& flags, const char* group) {
  command
      .add_flag("--collision-primitives", flags.collision_primitives,
                "Ask for a box, cylinder or sphere around each object, and boxes below what things "
                "stand on, for motion planners; in JSON")
      ->group(group);
  command
      .add_option("--height-map-cell", flags.height_map_cell_m,
                  "Ask for a height map, in JSON, with cells of this size; 0.02 where other flags "
                  "ask for one")
      ->type_name("METRES")
      ->check(flags::FiniteRange(0.002, 1))
      ->group(group);
  command
      .add_option("--height-map-max-cells", flags.height_map_max_cells,
                  "Cells at most, those nearest to the camera; 65536 unless given")
      ->type_name("N")
      ->check(CLI::Range(1, 1 << 20))
      ->group(group);
}

}  // namespace

void AddQuestionFlags(CLI::App& command, QuestionFlags& flags, const char* group) {
  AddMethodFlags(command, flags, group);
  AddHandFlags(command, flags, group);
  AddPlanningFlags(command, flags, group);
}

}  // namespace fovea::cli
