#include "server/config_file.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/options.h"
#include "flags/suggestion.h"
#include "server/byte_order_mark.h"
#include "server/config_lines.h"
#include "server/number_ranges.h"

namespace fovea::server {
namespace {

bool IsOptionOfTheMethod(const std::string& key) {
  const std::string group = key.substr(0, key.find('.') + 1);
  const auto options = ListOptions();
  return std::any_of(options.begin(), options.end(), [&](const OptionInfo& option) {
    return option.name == key || (!group.empty() && option.name.starts_with(group));
  });
}

std::string TextOf(std::istream& input) {
  constexpr std::size_t kLargest = 1 << 20;
  std::string text(kLargest + 1, '\0');
  input.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(input.gcount()));
  if (text.size() > kLargest) throw std::invalid_argument("--config: the file has more than 1 MiB");
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

}  // namespace

std::string ConfigFile::Remedy(const std::string& key) const {
  if (IsOptionOfTheMethod(key)) {
    return "options of the method come with each request, as by `fovea detect --set NAME=NUMBER`, "
           "or "
           "hold for all by option = [\"NAME=NUMBER\"]";
  }
  std::vector<std::string> keys;
  for (const CLI::Option* option : app_.get_options()) {
    if (!option->get_configurable()) continue;
    for (const std::string& name : option->get_lnames()) keys.push_back(name);
  }
  const std::string meant = flags::Suggest(key, keys);
  if (!meant.empty()) return "did you mean " + meant + "?";
  return "--help lists the flags, which are the keys";
}

void ConfigFile::Fail(std::size_t line, const std::string& what) const {
  throw std::invalid_argument("--config: " + app_.get_config_ptr()->as<std::string>() + ":" +
                              std::to_string(line) + ": " + what);
}

void ConfigFile::Check(const CLI::ConfigItem& item, const std::string& text) const {
  const bool is_section = item.name == "++" || item.name == "--";
  const std::string key = is_section ? CLI::detail::join(item.parents, ".") : item.fullname();
  const CLI::Option* option = is_section ? nullptr : app_.get_option_no_throw("--" + key);
  const auto fail = [&](std::size_t line, const std::string& what) {
    Fail(line, "\"" + key + "\" " + what);
  };
  const std::vector<std::size_t> lines = LinesOf(key, text);
  if (option != nullptr && lines.size() > 1) {  // CLI11 would make one list of both
    fail(lines.back(), "is there twice; several values are a list in one line");
  }
  const std::string what = Problem(option, item, is_section ? key + "." : key);
  if (!what.empty()) fail(lines.empty() ? 0 : lines.front(), what);
}

std::string ConfigFile::Problem(const CLI::Option* option, const CLI::ConfigItem& item,
                                const std::string& key) const {
  if (option == nullptr) return "is no key; " + Remedy(key);
  if (!option->get_configurable()) return "is for the command line only";
  const bool is_flag = option->get_expected_max() == 0;
  // CLI11 takes nothing, and any number but 0, for true.
  if (is_flag && item.inputs != std::vector<std::string>{"true"} &&
      item.inputs != std::vector<std::string>{"false"}) {
    return "must be true or false";
  }
  const auto most = static_cast<std::size_t>(option->get_expected_max());
  if (!is_flag && item.inputs.size() > most) return "must be one value, not a list of several";
  for (const std::string& input : item.inputs) {
    const std::string why = input.empty() ? "" : WhyNoNumber("--" + key, input);
    if (!why.empty()) return why + ": \"" + input + "\"";
  }
  return {};
}

std::vector<CLI::ConfigItem> ConfigFile::from_config(std::istream& input) const {
  const std::string text = TextOf(input);
  if (const auto fault = FirstFault(text)) Fail(fault->line, fault->what);
  std::istringstream copy(text);
  std::vector<CLI::ConfigItem> found = CLI::ConfigTOML::from_config(copy);
  for (const CLI::ConfigItem& item : found) Check(item, text);
  return found;
}

}  // namespace fovea::server
