#include "flags/plain_values.h"

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fovea::flags {
namespace {

constexpr const char* kIsEmpty = "is empty; leave it out for what holds without it";

bool IsNumber(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type == "INT" || type == "UINT" || type == "FLOAT";
}

bool HasLeadingZero(const std::string& number) {
  const std::size_t first = number.find_first_not_of("+-");
  return first != std::string::npos && first + 1 < number.size() && number[first] == '0' &&
         number[first + 1] >= '0' && number[first + 1] <= '9';
}

}  // namespace

void RequirePlainValues(CLI::App& app) {
  for (CLI::Option* option : app.get_options([](CLI::Option*) { return true; })) {
    if (option->get_expected_max() == 0) continue;  // a flag
    const auto problem_of = [is_number = IsNumber(*option)](const std::string& value) {
      if (value.empty()) return std::string(kIsEmpty);
      if (is_number && HasLeadingZero(value)) return "\"" + value + "\" begins with a zero";
      return std::string();
    };
    option->check(CLI::Validator(problem_of, ""));
  }
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    RequirePlainValues(*command);
  }
}

void RequireValuesBehindEquals(int argc, const char* const* argv) {
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    const std::string_view word(argv[i]);
    if (!word.starts_with("--") || word.find('=') != word.size() - 1) continue;
    throw std::invalid_argument(std::string(word.substr(0, word.size() - 1)) + ": " + kIsEmpty);
  }
}

}  // namespace fovea::flags
