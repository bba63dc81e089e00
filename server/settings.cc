#include "server/settings.h"

#include <spdlog/spdlog.h>

#include "server/http/http_url.h"
#include "server/logging/log_record.h"

namespace fovea::server {

Settings SettingsOf(const CLI::App& app) {
  Settings settings;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_configurable() || option->get_lnames().empty()) continue;
    settings[option->get_lnames().front()] =
        option->count() > 0 ? CLI::detail::join(option->results(), ",") : option->get_default_str();
  }
  return settings;
}

std::vector<std::string> ChangedKeys(const Settings& before, const Settings& after) {
  std::vector<std::string> changed;
  for (const auto& [key, value] : after) {
    const auto found = before.find(key);
    if (found == before.end() || found->second != value) changed.push_back(key);
  }
  return changed;
}

std::string ForPeople(const std::string& key, const std::string& value) {
  return key == "trace-endpoint" ? WithoutSecrets(value) : value;
}

void LogSettings(const Settings& settings) {
  LogRecord record("configuration");
  for (const auto& [key, value] : settings) {
    if (!value.empty()) record.Text(key, ForPeople(key, value));
  }
  record.Log(spdlog::level::info);
}

}  // namespace fovea::server
