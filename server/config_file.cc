#include "server/config_file.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/options.h"

namespace fovea::server {
namespace {

// Levenshtein's: how many characters to insert, delete or replace.
std::size_t EditDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({row[j] + 1, row[j + 1] + 1, replaced}));
    }
  }
  return row.back();
}

bool IsOptionOfTheMethod(const std::string& key) {
  const std::string group = key.substr(0, key.find('.') + 1);
  const auto options = ListOptions();
  return std::any_of(options.begin(), options.end(), [&](const OptionInfo& option) {
    return option.name == key || (!group.empty() && option.name.starts_with(group));
  });
}

// Of the first line that starts with this key or section.
std::size_t LineOf(const std::string& key, const std::string& text) {
  std::istringstream lines(text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t start = std::min(line.find_first_not_of(" \t\"'["), line.size());
    const std::size_t end = start + key.size();
    if (line.compare(start, key.size(), key) != 0) continue;
    if (end == line.size() || line.find_first_of(" \t=\"']", end) == end) return number;
  }
  return 0;
}

}  // namespace

std::string ConfigFile::Remedy(const std::string& key) const {
  if (IsOptionOfTheMethod(key)) {
    return "options of the method come with each request, as by `fovea detect --set NAME=NUMBER`, "
           "or "
           "hold for all by option = [\"NAME=NUMBER\"]";
  }
  constexpr std::size_t kFewTypos = 2;
  for (const CLI::Option* option : app_.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      if (option->get_configurable() && EditDistance(name, key) <= kFewTypos) {
        return "did you mean " + name + "?";
      }
    }
  }
  return "--help lists the flags, which are the keys";
}

void ConfigFile::Check(const CLI::ConfigItem& item, const std::string& text) const {
  const bool is_section = item.name == "++" || item.name == "--";
  const std::string key = is_section ? CLI::detail::join(item.parents, ".") : item.fullname();
  const CLI::Option* option = is_section ? nullptr : app_.get_option_no_throw("--" + key);
  if (option != nullptr && option->get_configurable()) return;
  const std::string place =
      app_.get_config_ptr()->as<std::string>() + ":" + std::to_string(LineOf(key, text));
  const std::string what = option != nullptr
                               ? "\" is for the command line only"
                               : "\" is no key; " + Remedy(is_section ? key + "." : key);
  throw std::invalid_argument("--config: " + place + ": \"" + key + what);
}

std::vector<CLI::ConfigItem> ConfigFile::from_config(std::istream& input) const {
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  std::istringstream copy(text);
  std::vector<CLI::ConfigItem> found = CLI::ConfigTOML::from_config(copy);
  for (const CLI::ConfigItem& item : found) Check(item, text);
  return found;
}

}  // namespace fovea::server
