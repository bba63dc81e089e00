// Values of flags. All throw std::invalid_argument that names the flag and shows the text.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fovea::cli {

// "525,525,319.5,239.5" → `count` numbers. `form` is how it should look: "FX,FY,CX,CY".
std::vector<double> ParseNumbers(const std::string& text, std::size_t count,
                                 const std::string& flag, const std::string& form);

// "name=value".
std::pair<std::string, double> ParseSetting(const std::string& text);

}  // namespace fovea::cli
