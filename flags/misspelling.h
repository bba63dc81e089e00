#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fovea::flags {

// "; did you mean --listen?" about the first word of the command line that is no flag or command of
// `app`, where one resembles it; else nothing. Words behind "--" are somebody else's. CLI11 says
// which words were left over, and nothing of what they resemble.
std::string Misspelling(const CLI::App& app, int argc, const char* const* argv);

// Makes app.exit(), when parsing this command line failed, print one line with the program's name,
// the error and what may have been meant. `app` has its flags by then; `argv` outlives it.
void NameMisspellings(CLI::App& app, int argc, const char* const* argv);

}  // namespace fovea::flags
