// What the sub-commands show while they run and leave behind.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fovea::evaluation {

// A bar on standard error that draws over its own line; silent when no one watches.
void ShowProgress(const std::string& what, std::size_t done, std::size_t total);

// Why no file can be written there, "" if one can: a check of CLI11, for flags that name what hours
// of computing end in. Leaves what is there, or not there, as it is.
std::string WhyNotWritable(const std::string& path);

// Write a file; nothing where `path` is empty. Throw std::runtime_error if it cannot be written.
void WriteText(const std::string& path, const std::string& text);
void WriteJson(const std::string& path, const nlohmann::json& json);

}  // namespace fovea::evaluation
