#include "server/options_page.h"

#include <spdlog/fmt/fmt.h>

#include <map>
#include <vector>

#include "core/options.h"

namespace fovea::server {
namespace {

std::string Row(const OptionInfo& option,
                const std::vector<std::map<std::string, double>>& profiles) {
  std::string row = fmt::format("| `{}` | {} … {}{} |", option.name, option.minimum, option.maximum,
                                option.integral ? ", whole" : "");
  for (const auto& values : profiles) {
    const auto value = values.find(option.name);
    row += value == values.end() ? " – |" : fmt::format(" {} |", value->second);
  }
  return row + " " + option.description + " |\n";
}

}  // namespace

std::string OptionsAsMarkdown() {
  std::string head = "| option | range |", rule = "|---|---|";
  std::vector<std::map<std::string, double>> profiles;
  for (const std::string& name : ProfileNames()) {
    profiles.push_back(OptionValues(OptionsOfProfile(name)));
    head += " " + name + " |";
    rule += "---|";
  }
  std::string table = head + " meaning |\n" + rule + "---|\n";
  for (const OptionInfo& option : ListOptions()) table += Row(option, profiles);
  return table;
}

}  // namespace fovea::server
