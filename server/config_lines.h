// The lines of a configuration file. CLI11 skips some of those that say nothing, takes a key alone
// for true, and goes on with a list in the next line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fovea::server {

struct LineFault {
  std::size_t line = 0;  // from 1
  std::string what;
};

// The first line that is neither KEY = VALUE nor [SECTION], nor empty or a comment. VALUE is one,
// in quotes or without, or a list of them in brackets.
std::optional<LineFault> FirstFault(const std::string& text);

// Numbers of the lines that start with this key or section.
std::vector<std::size_t> LinesOf(const std::string& key, const std::string& text);

}  // namespace fovea::server
