#pragma once

#include <string>
#include <string_view>

namespace fovea::flags {

// The text as people's terminals and logs can take it: control characters, which may be in names of
// files and values of flags, are shown as "\n" or "\x1b". All else stays, quotes and UTF-8 too.
std::string OneLine(std::string_view text);

}  // namespace fovea::flags
