// What the flags of question_flags.h mean.
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "client/cli/parsing.h"
#include "client/cli/question_flags.h"

namespace fovea::cli {
namespace {

// METRES or METRES,LEAST: the least probability of what is returned.
double ParseHand(const std::string& text, const std::string& form, v1::Gripper* gripper) {
  const std::size_t count = text.find(',') == std::string::npos ? 1 : 2;
  const auto numbers = ParseNumbers(text, count, "--gripper", form);
  if (count == 2) gripper->set_min_probability(numbers.back());
  if (!(numbers.front() > 0)) {  // in the contract 0 stands for the usual length
    throw std::invalid_argument("--gripper: \"" + text + "\" is not a length above 0 metres");
  }
  return numbers.front();
}

v1::Gripper ParseGripper(const std::string& text) {
  const std::string form =
      "jaw=OPENING or suction=DIAMETER in metres, with ,LEAST probability or without, none, or "
      "JSON";
  v1::Gripper gripper;
  if (text.starts_with("{")) {
    const auto status = google::protobuf::util::JsonStringToMessage(text, &gripper);
    if (status.ok()) return gripper;
    const std::string reason(status.message());  // the lines after the first show the place
    throw std::invalid_argument("--gripper: " + text + " is no fovea.v1.Gripper in JSON: " +
                                reason.substr(0, reason.find('\n')));
  }
  gripper.set_name(text);
  if (text.starts_with("jaw=")) {
    gripper.mutable_jaw()->set_max_opening_m(ParseHand(text.substr(4), form, &gripper));
  } else if (text.starts_with("suction=")) {
    gripper.mutable_suction()->set_diameter_m(ParseHand(text.substr(8), form, &gripper));
  } else {
    throw std::invalid_argument(
        std::string("--gripper: \"").append(text).append("\" is not ").append(form));
  }
  return gripper;
}

void SetGrippers(const std::vector<std::string>& texts, v1::DetectOptions* options) {
  for (const std::string& text : texts) {
    if (text == "none") {
      options->mutable_grasps()->set_none(true);
    } else {
      *options->mutable_grasps()->add_grippers() = ParseGripper(text);
    }
  }
}

void SetPlaces(const QuestionFlags& flags, v1::DetectOptions* options) {
  if (flags.place.empty()) return;
  const auto size = ParseNumbers(flags.place, 3, "--place", "LENGTH,WIDTH,HEIGHT in metres");
  v1::PlaceOptions& places = *options->mutable_places();
  places.mutable_size()->set_x(size[0]);
  places.mutable_size()->set_y(size[1]);
  places.mutable_size()->set_z(size[2]);
  if (flags.place_margin_m) places.set_margin_m(*flags.place_margin_m);
  if (flags.max_places) places.set_max_places(*flags.max_places);
}

void SetPlanning(const QuestionFlags& flags, v1::DetectOptions* options) {
  if (flags.collision_primitives) options->mutable_planning()->set_collision_primitives(true);
  if (!flags.height_map_cell_m && !flags.height_map_max_cells) return;
  v1::HeightMapOptions& map = *options->mutable_planning()->mutable_height_map();
  if (flags.height_map_cell_m) map.set_cell_m(*flags.height_map_cell_m);
  if (flags.height_map_max_cells) map.set_max_cells(*flags.height_map_max_cells);
}

void SetTimeBudget(std::optional<double> seconds, v1::DetectOptions* options) {
  if (!seconds) return;
  // Zero on the wire stands for no limit.
  const long long least = *seconds > 0 ? 1 : 0;
  *options->mutable_time_budget() = google::protobuf::util::TimeUtil::NanosecondsToDuration(
      std::max(least, std::llround(*seconds * 1e9)));
}

}  // namespace

v1::DetectOptions DetectOptionsOf(const QuestionFlags& flags) {
  v1::DetectOptions options;
  options.set_profile(flags.profile);
  for (const std::string& text : flags.settings) {
    const auto [name, value] = ParseSetting(text);
    (*options.mutable_parameters())[name] = value;
  }
  SetGrippers(flags.grippers, &options);
  SetPlaces(flags, &options);
  SetPlanning(flags, &options);
  SetTimeBudget(flags.time_budget_s, &options);
  return options;
}

}  // namespace fovea::cli
