#include "server/conversion/option_list.h"

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "core/options.h"

namespace fovea::server {
namespace {

// Names end with their unit. Longer ends come first.
const char* UnitOf(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, const char*>, 6> kUnits{{{"_per_m2", "1/m2"},
                                                                            {"_per_m", "1/m"},
                                                                            {"_m2", "m2"},
                                                                            {"_m", "m"},
                                                                            {"_deg", "deg"},
                                                                            {"_px", "px"}}};
  for (const auto& [end, unit] : kUnits) {
    if (name.ends_with(end)) return unit;
  }
  return "";
}

v1::Option OptionProto(const OptionInfo& info) {
  v1::Option option;
  option.set_name(info.name);
  option.set_unit(UnitOf(info.name));
  option.set_minimum(info.minimum);
  option.set_maximum(info.maximum);
  option.set_integral(info.integral);
  option.set_description(info.description);
  return option;
}

}  // namespace

v1::ListOptionsResponse OptionList(const OptionPolicy& policy) {
  v1::ListOptionsResponse list;
  for (const OptionInfo& info : ListOptions()) {
    v1::Option& option = *list.add_options();
    option = OptionProto(info);
    option.set_fixed(!policy.MaySet(info.name));
  }
  for (const std::string& profile : ProfileNames()) {
    const std::map<std::string, double> values =
        OptionValues(policy.Applied(OptionsOfProfile(profile)));
    for (v1::Option& option : *list.mutable_options()) {
      const auto value = values.find(option.name());
      if (value != values.end()) (*option.mutable_defaults())[profile] = value->second;
    }
  }
  return list;
}

}  // namespace fovea::server
