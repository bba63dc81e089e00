#include "server/reload.h"

#include <spdlog/spdlog.h>

#include <exception>

#include "flags/one_line.h"
#include "server/command_line.h"
#include "server/logging/logging.h"

namespace fovea::server {
namespace {

constexpr const char* kLogLevel = "log-level";

}  // namespace

void Reload(int argc, char** argv, Server& server, Settings* in_force) {
  try {
    Settings settings;
    const auto options = ParseCommandLine(argc, argv, &settings);
    server.ReloadAccess();
    Logging::SetLevel(options->log_level);
    in_force->at(kLogLevel) = settings.at(kLogLevel);
    for (const std::string& key : ChangedKeys(*in_force, settings)) {
      spdlog::warn("{}: changed, needs a restart", key);
    }
    spdlog::warn("read configuration, tokens and certificates again, log level is {}",
                 options->log_level);
  } catch (const std::exception& error) {
    spdlog::error("the configuration stays as it was: {}", flags::OneLine(error.what()));
  }
}

}  // namespace fovea::server
