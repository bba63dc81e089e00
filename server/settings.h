// The configuration in force, for people.
#pragma once

#include <CLI/App.hpp>
#include <map>
#include <string>
#include <vector>

namespace fovea::server {

// By key: what was given on the command line or in the file, else the default.
using Settings = std::map<std::string, std::string>;

Settings SettingsOf(const CLI::App& app);

// In the order of the names.
std::vector<std::string> ChangedKeys(const Settings& before, const Settings& after);

// The value as logs and terminals may have it: without the query of a URL, which may hold a key.
std::string ForPeople(const std::string& key, const std::string& value);

// One line in the log.
void LogSettings(const Settings& settings);

}  // namespace fovea::server
