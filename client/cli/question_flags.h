// What the server is asked about frames, in flags that fovea detect and fovea-capture share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fovea/v1/detection.pb.h"

namespace CLI {
class App;
}

namespace fovea::cli {

// As they were written; what is absent stays absent in the request.
struct QuestionFlags {
  std::string profile, place;
  std::vector<std::string> settings, grippers;
  std::optional<double> time_budget_s, place_margin_m, height_map_cell_m;
  std::optional<std::uint32_t> max_places, height_map_max_cells;
  bool collision_primitives = false;
};

void AddQuestionFlags(CLI::App& command, QuestionFlags& flags, const char* group);

// Throws std::invalid_argument that names the flag.
v1::DetectOptions DetectOptionsOf(const QuestionFlags& flags);

}  // namespace fovea::cli
