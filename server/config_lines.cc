#include "server/config_lines.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace fovea::server {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr std::string_view kQuotes = "\"'`";

std::string_view Trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

bool BeginsWithOneOf(std::string_view text, std::string_view characters) {
  return !text.empty() && characters.find(text.front()) != std::string_view::npos;
}

// Of the value that the text begins with, which without quotes ends at one of `ends`; 0 = none.
std::size_t LengthOfValue(std::string_view text, std::string_view ends) {
  if (!BeginsWithOneOf(text, kQuotes)) return std::min(text.find_first_of(ends), text.size());
  std::size_t end = text.find(text.front(), 1);
  while (end != std::string_view::npos && text[end - 1] == '\\') {
    end = text.find(text.front(), end + 1);
  }
  return end == std::string_view::npos ? 0 : end + 1;
}

// `list`: what is between the brackets.
bool IsList(std::string_view list) {
  while (const std::size_t length = LengthOfValue(list, ",")) {
    list = Trimmed(list.substr(length));
    if (list.empty()) return true;
    if (list.front() != ',') return false;
    list = Trimmed(list.substr(1));
  }
  return false;
}

std::string FaultOfValue(std::string_view value) {
  if (value.empty()) return "has no value; a line is KEY = VALUE";
  if (value.front() == '[') {
    if (value.back() != ']') {
      return "is a list that must end in its line; an address with brackets needs quotes";
    }
    const std::string_view list = Trimmed(value.substr(1, value.size() - 2));
    return IsList(list) ? "" : "must be a list of values with commas between, [\"A\", \"B\"]";
  }
  if (LengthOfValue(value, ", \t\r") == value.size()) return {};
  return "must be one value, in quotes where it has blanks or commas, or a list in brackets";
}

// A section is no key, as whoever knows the keys says; but CLI11 skips these.
bool IsSkippedSection(std::string_view line) {
  const std::size_t start = std::min(line.find_first_not_of('['), line.size());
  const std::size_t end = line.find_last_not_of(']') + 1;
  if (end <= start) return true;
  std::string name(line.substr(start, end - start));
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name == "default";
}

std::string FaultOfLine(std::string_view line) {
  line = Trimmed(line);
  if (line.starts_with(';')) return "comments begin with #";
  line = Trimmed(line.substr(0, line.find('#')));
  if (line.empty()) return {};
  if (line.front() == '[' && line.back() == ']' && !IsSkippedSection(line)) return {};
  const std::size_t equals = std::min(line.find('='), line.size());
  const std::string_view key = Trimmed(line.substr(0, equals));
  if (key.empty()) return "there is no key before =";
  const std::string_view value = Trimmed(line.substr(std::min(equals + 1, line.size())));
  const std::string what = FaultOfValue(value);
  return what.empty() ? "" : "\"" + std::string(key) + "\" " + what;
}

}  // namespace

std::optional<LineFault> FirstFault(const std::string& text) {
  std::istringstream lines(text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string what = FaultOfLine(line);
    if (!what.empty()) return LineFault{number, what};
  }
  return std::nullopt;
}

std::vector<std::size_t> LinesOf(const std::string& key, const std::string& text) {
  std::vector<std::size_t> found;
  std::istringstream lines(text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t start = std::min(line.find_first_not_of(" \t\"'["), line.size());
    const std::size_t end = start + key.size();
    if (line.compare(start, key.size(), key) != 0) continue;
    if (end == line.size() || line.find_first_of(" \t=\"']", end) == end) found.push_back(number);
  }
  return found;
}

}  // namespace fovea::server
