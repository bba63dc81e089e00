#include "client/cli/program.h"

#include <grpc/support/log.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "client/cli/suggestion.h"

namespace fovea::cli {
namespace {

std::vector<std::string> FlagsOf(const CLI::App& app) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  }
  return flags;
}

std::vector<std::string> CommandsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

// "; did you mean detect?" about the first word that is none of the program's, else nothing. CLI11
// says which words were left over, and nothing of what they resemble.
std::string Suggestion(const CLI::App& app, int argc, char** argv) {
  const CLI::App* command = &app;
  for (int i = 1; i < argc; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (word.starts_with("--")) {
      const std::vector<std::string> flags = FlagsOf(*command);
      if (std::find(flags.begin(), flags.end(), word) != flags.end()) continue;
      const std::string meant = Suggest(word, flags);
      return meant.empty() ? "" : "; did you mean " + meant + "?";
    }
    if (command != &app || i > 1) continue;
    const std::vector<std::string> names = CommandsOf(app);
    if (std::find(names.begin(), names.end(), word) != names.end()) {
      command = app.get_subcommand(word);
      continue;
    }
    const std::string meant = Suggest(word, names);
    if (!meant.empty()) return "; did you mean " + meant + "?";
  }
  return {};
}

}  // namespace

int RunProgram(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  // What matters of gRPC's own messages comes back as the status of the call.
  gpr_set_log_function([](gpr_log_func_args*) {});
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::Success& wants_text) {  // --help, --version
    return app.exit(wants_text);
  } catch (const CLI::ParseError& error) {
    std::cerr << app.get_name() << ": " << error.what() << Suggestion(app, argc, argv)
              << " (--help lists the flags)\n";
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}

}  // namespace fovea::cli
