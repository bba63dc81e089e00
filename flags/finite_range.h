#pragma once

#include <CLI/CLI.hpp>

namespace fovea::flags {

// A number from `minimum` to `maximum`, both included. Unlike CLI::Range, which compares with < and
// >, this refuses NaN; infinities are refused whatever the range.
CLI::Validator FiniteRange(double minimum, double maximum);

}  // namespace fovea::flags
