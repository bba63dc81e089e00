#include "server/conversion/option_policy.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <string_view>

namespace fovea::server {
namespace {

// Where to look, and which of the objects to report.
constexpr std::array<std::string_view, 2> kSafe{"region.", "objects."};

OptionPolicy::Clients ParseClients(const std::string& text) {
  if (text == "none") return OptionPolicy::Clients::kNone;
  if (text == "safe") return OptionPolicy::Clients::kSafe;
  if (text == "all") return OptionPolicy::Clients::kAll;
  throw std::invalid_argument("--client-options: \"" + text + "\" is not one of none, safe, all");
}

double ParseValue(const std::string& option, std::size_t equals) {
  double value = 0;
  const char* end = option.data() + option.size();
  const auto parsed = std::from_chars(option.data() + equals + 1, end, value);
  if (equals != std::string::npos && parsed.ec == std::errc{} && parsed.ptr == end) return value;
  throw std::invalid_argument("--option: \"" + option + "\" is not NAME=NUMBER");
}

}  // namespace

OptionPolicy::OptionPolicy(const std::string& clients, const std::vector<std::string>& fixed)
    : clients_(ParseClients(clients)) {
  for (const std::string& option : fixed) {
    const std::size_t equals = option.find('=');
    const double value = ParseValue(option, equals);
    fixed_[option.substr(0, equals)] = value;
  }
  try {
    for (const std::string& profile : ProfileNames()) Validate(Applied(OptionsOfProfile(profile)));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("--option: " + std::string(error.what()));
  }
}

bool OptionPolicy::MaySet(const std::string& name) const {
  if (clients_ == Clients::kAll) return !fixed_.contains(name);
  if (clients_ == Clients::kNone || fixed_.contains(name)) return false;
  return std::ranges::any_of(kSafe,
                             [&](std::string_view group) { return name.starts_with(group); });
}

DetectorOptions OptionPolicy::Applied(DetectorOptions options) const {
  for (const auto& [name, value] : fixed_) {
    // Profiles read different ones; what none reads is an error.
    if (HasOption(options, name) || !IsOption(name)) SetOption(options, name, value);
  }
  return options;
}

}  // namespace fovea::server
