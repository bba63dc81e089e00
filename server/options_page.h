#pragma once

#include <string>

namespace fovea::server {

// Every option of the method as a Markdown table: name, range, value in each profile, meaning.
std::string OptionsAsMarkdown();

}  // namespace fovea::server
