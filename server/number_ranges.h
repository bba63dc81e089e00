// The numbers that flags of the server take.
#pragma once

#include <string>

#include "server/server_options.h"

namespace fovea::server {

// Throws std::invalid_argument that names the first flag whose number is beyond its range.
void RequireRanges(const ServerOptions& options);

// "1 to 10000"; empty for flags that take no whole number.
std::string RangeOf(const std::string& flag);

// Why this text is no value of the flag ("is not a whole number between 1 and 10000"): it is no
// number, or one beyond all. Empty where it is a number, of whatever range, and for flags that take
// other things.
std::string WhyNoNumber(const std::string& flag, const std::string& text);

}  // namespace fovea::server
