#pragma once

#include <spdlog/formatter.h>

#include <memory>
#include <string>

namespace fovea::server {

enum class LogFormat { kText, kJson };

// Of "json", else text.
LogFormat ParseLogFormat(const std::string& name);

// That of the process; text until SetLogFormat.
LogFormat GetLogFormat();
void SetLogFormat(LogFormat format);

// What a message begins with that is no text but members of a JSON object.
constexpr const char* kMembersFollow = "\x1E";

// Text: `2027-01-31T12:00:00.123+00:00 info message`. JSON: an object a line with "time", "level"
// and "message", or the members instead of that.
std::unique_ptr<spdlog::formatter> MakeFormatter(LogFormat format);

}  // namespace fovea::server
