#include "core/options.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "core/options_table.h"

namespace fovea {
namespace {

template <typename T>
constexpr bool kIsValue = !std::is_same_v<std::decay_t<T>, std::monostate>;

// None where the profile of the options does not read it.
std::optional<double> Get(const OptionEntry& entry, const DetectorOptions& options) {
  // The table locates members of mutable options; reading does not change them.
  return std::visit(
      [](auto value) -> std::optional<double> {
        if constexpr (kIsValue<decltype(value)>) return static_cast<double>(*value);
        return std::nullopt;
      },
      entry.locate(const_cast<DetectorOptions&>(options)));
}

void Check(const OptionInfo& info, double value) {
  const bool whole = !info.integral || value == std::floor(value);
  if (value >= info.minimum && value <= info.maximum && whole) return;
  std::ostringstream message;
  message << info.name << ": " << value << " is not " << (info.integral ? "a whole number " : "")
          << "in the range " << info.minimum << " to " << info.maximum;
  throw std::invalid_argument(message.str());
}

// Null where there is no option of this name.
const OptionEntry* FindEntry(std::string_view name) {
  for (const OptionEntry& entry : OptionTable()) {
    if (entry.info.name == name) return &entry;
  }
  return nullptr;
}

}  // namespace

std::vector<OptionInfo> ListOptions() {
  std::vector<OptionInfo> infos;
  for (const OptionEntry& entry : OptionTable()) infos.push_back(entry.info);
  return infos;
}

std::map<std::string, double> OptionValues(const DetectorOptions& options) {
  std::map<std::string, double> values;
  for (const OptionEntry& entry : OptionTable()) {
    if (const auto value = Get(entry, options)) values[entry.info.name] = *value;
  }
  return values;
}

bool IsOption(std::string_view name) { return FindEntry(name) != nullptr; }

bool HasOption(const DetectorOptions& options, std::string_view name) {
  const OptionEntry* entry = FindEntry(name);
  return entry != nullptr && Get(*entry, options).has_value();
}

void SetOption(DetectorOptions& options, std::string_view name, double value) {
  const OptionEntry* entry = FindEntry(name);
  if (entry == nullptr) {
    throw std::invalid_argument(std::string(name) + ": there is no option of this name");
  }
  if (!HasOption(options, name)) {
    throw std::invalid_argument(std::string(name) + ": profile \"" +
                                (options.paper ? "paper" : "default") + "\" does not read it");
  }
  Check(entry->info, value);
  std::visit(
      [value](auto member) {
        if constexpr (kIsValue<decltype(member)>) {
          *member = static_cast<std::remove_pointer_t<decltype(member)>>(value);
        }
      },
      entry->locate(options));
}

void Validate(const DetectorOptions& options) {
  const double budget_ms = options.time_budget.count();
  if (!(budget_ms >= 0 && budget_ms <= 3'600'000)) {
    throw std::invalid_argument("time_budget: must be 0 (none) or up to an hour");
  }
  for (const OptionEntry& entry : OptionTable()) {
    if (const auto value = Get(entry, options)) Check(entry.info, *value);
  }
}

}  // namespace fovea
