#include "flags/misspelling.h"

#include <CLI/App.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

#include "flags/one_line.h"
#include "flags/suggestion.h"

namespace fovea::flags {
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

bool IsOneOf(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string Meant(const std::string& word, const std::vector<std::string>& known) {
  const std::string meant = Suggest(word, known);
  return meant.empty() ? "" : "; did you mean " + meant + "?";
}

}  // namespace

std::string Misspelling(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::App* command = &app;
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (word.starts_with("--")) {
      const std::vector<std::string> flags = FlagsOf(*command);
      if (!IsOneOf(word, flags)) return Meant(word, flags);
    } else if (i == 1) {
      const std::vector<std::string> commands = CommandsOf(app);
      if (IsOneOf(word, commands)) {
        command = app.get_subcommand(word);
      } else if (std::string meant = Meant(word, commands); !meant.empty()) {
        return meant;
      }
    }
  }
  return {};
}

void NameMisspellings(CLI::App& app, int argc, const char* const* argv) {
  app.failure_message([argc, argv](const CLI::App* failed, const CLI::Error& error) {
    return failed->get_name() + ": " + OneLine(error.what() + Misspelling(*failed, argc, argv)) +
           " (--help lists the flags)\n";
  });
}

}  // namespace fovea::flags
