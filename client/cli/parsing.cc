#include "client/cli/parsing.h"

#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace fovea::cli {
namespace {

std::optional<double> ParseNumber(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string_view WithoutBlanks(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

[[noreturn]] void Fail(const std::string& flag, const std::string& text, const std::string& form) {
  throw std::invalid_argument(flag + ": \"" + text + "\" is not " + form);
}

}  // namespace

std::vector<double> ParseNumbers(const std::string& text, std::size_t count,
                                 const std::string& flag, const std::string& form) {
  std::vector<double> numbers;
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const auto number = ParseNumber(WithoutBlanks(rest.substr(0, comma)));
    if (!number) Fail(flag, text, form);
    numbers.push_back(*number);
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (numbers.size() != count) Fail(flag, text, form);
  return numbers;
}

std::pair<std::string, double> ParseSetting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) Fail("--set", text, "NAME=NUMBER");
  const auto value = ParseNumber(std::string_view(text).substr(equals + 1));
  if (!value) Fail("--set", text, "NAME=NUMBER");
  return {text.substr(0, equals), *value};
}

}  // namespace fovea::cli
