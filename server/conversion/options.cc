#include "server/conversion/options.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "server/conversion/field_error.h"
#include "server/conversion/gripper.h"
#include "server/conversion/place.h"
#include "server/conversion/planning.h"

namespace fovea::server {
namespace {

// Names come from the caller and return in the status text, which travels in a header.
std::string Shortened(const std::string& name) {
  constexpr std::size_t kMax = 64;
  if (name.size() <= kMax) return name;
  std::size_t end = kMax;  // not inside of a character
  while ((static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
  return name.substr(0, end) + "…";
}

std::string Joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

// The part before the dot: "mrf" of "mrf.gamma_per_m2".
std::string GroupOf(const std::string& name) { return name.substr(0, name.find('.')); }

// Those of the same group, or the names of all groups where the group is unknown too.
std::string Suggestions(const std::string& name) {
  std::vector<std::string> near, groups;
  for (const OptionInfo& option : ListOptions()) {
    const std::string group = GroupOf(option.name);
    if (group == GroupOf(name)) near.push_back(option.name);
    if (groups.empty() || groups.back() != group) groups.push_back(group);
  }
  if (!near.empty()) return "known are " + Joined(near);
  return "known names start with " + Joined(groups);
}

// The core starts its texts with the option's name, which is in the path already.
std::string WithoutName(const std::string& text, const std::string& name) {
  const std::string start = name + ": ";
  return text.starts_with(start) ? text.substr(start.size()) : text;
}

void SetParameter(DetectorOptions& options, const std::string& name, double value,
                  const OptionPolicy& policy) {
  const std::string path = "options.parameters[" + Shortened(name) + "]";
  RequireField(IsOption(name), path, "there is no such option; " + Suggestions(name));
  RequireField(policy.MaySet(name), path,
               "the operator of this server lets no request set it (client-options, option in "
               "the server's configuration)");
  RequireField(std::isfinite(value), path, "must be a finite number");
  try {
    SetOption(options, name, value);
  } catch (const std::invalid_argument& error) {
    FailField(path, WithoutName(error.what(), name));
  }
}

DetectorOptions ProfileFromProto(const std::string& name, const OptionPolicy& policy) {
  RequireField(name.empty() || policy.MayChooseProfile(), "options.profile",
               "the operator of this server lets no request choose one");
  const auto names = ProfileNames();
  const bool known = name.empty() || std::find(names.begin(), names.end(), name) != names.end();
  RequireField(known, "options.profile", Shortened(name) + " is not one of " + Joined(names));
  return OptionsOfProfile(name);
}

std::chrono::duration<double, std::milli> TimeBudgetFromProto(const v1::DetectOptions& options) {
  if (!options.has_time_budget()) return {};
  constexpr std::int64_t kMax_s = 3600;
  const google::protobuf::Duration& budget = options.time_budget();
  const bool is_in_range =
      budget.seconds() >= 0 && budget.nanos() >= 0 && budget.nanos() < 1'000'000'000 &&
      (budget.seconds() < kMax_s || (budget.seconds() == kMax_s && budget.nanos() == 0));
  RequireField(is_in_range, "options.time_budget", "must be from 0 (none) to an hour");
  const std::chrono::duration<double, std::milli> time =
      std::chrono::seconds(budget.seconds()) + std::chrono::nanoseconds(budget.nanos());
  RequireField(time.count() == 0 || !options.return_trace(), "options.time_budget",
               "does not go with return_trace, which is of the whole frame");
  return time;
}

}  // namespace

DetectorOptions FromProto(const v1::DetectOptions& options, const OptionPolicy& policy) {
  DetectorOptions result = policy.Applied(ProfileFromProto(options.profile(), policy));
  // In the order of the names, so that the first error is always the same one.
  const std::map<std::string, double> parameters(options.parameters().begin(),
                                                 options.parameters().end());
  for (const auto& [name, value] : parameters) SetParameter(result, name, value, policy);
  result.time_budget = TimeBudgetFromProto(options);
  result.grippers = FromProto(options.grasps());
  result.place = PlaceFromProto(options);
  result.planning = PlanningFromProto(options);
  InParameters([&] { Validate(result); });
  return result;
}

}  // namespace fovea::server
