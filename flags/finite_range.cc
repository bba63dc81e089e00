#include "flags/finite_range.h"

#include <cmath>
#include <sstream>
#include <string>

namespace fovea::flags {

CLI::Validator FiniteRange(double minimum, double maximum) {
  std::ostringstream range;
  range << minimum << " to " << maximum;
  const auto problem_of = [minimum, maximum, range = range.str()](const std::string& text) {
    double value = 0;
    const bool is_inside = CLI::detail::lexical_cast(text, value) && std::isfinite(value) &&
                           value >= minimum && value <= maximum;
    return is_inside ? std::string() : "\"" + text + "\" is not a number from " + range;
  };
  return CLI::Validator(problem_of, "FLOAT in [" + range.str() + "]");
}

}  // namespace fovea::flags
