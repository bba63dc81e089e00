#pragma once

namespace CLI {
class App;
}

namespace fovea::flags {

// Has options of `app` and its commands refuse values that are empty, as a script or a template
// with an unset variable makes them, and that would pass for none or zero; and numbers with leading
// zeros, which would be octal.
void RequirePlainValues(CLI::App& app);

// Throws std::invalid_argument that names the first word of the command line that ends in "=":
// CLI11 takes "--insecure=" for "--insecure". Words behind "--" are somebody else's.
void RequireValuesBehindEquals(int argc, const char* const* argv);

}  // namespace fovea::flags
