#include "client/cli/program.h"

#include <grpc/support/log.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "flags/misspelling.h"
#include "flags/one_line.h"
#include "flags/plain_values.h"

namespace fovea::cli {

int RunProgram(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is an error like others
  // What matters of gRPC's own messages comes back as the status of the call.
  gpr_set_log_function([](gpr_log_func_args*) {});
  try {
    flags::RequirePlainValues(app);
    flags::RequireValuesBehindEquals(argc, argv);
    app.parse(argc, argv);
    const int code = run();
    if (!std::cout.flush()) throw std::runtime_error("standard output cannot be written");
    return code;
  } catch (const CLI::Success& wants_text) {  // --help, --version
    return app.exit(wants_text);
  } catch (const CLI::ParseError& error) {
    flags::NameMisspellings(app, argc, argv);
    app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << flags::OneLine(error.what()) << '\n';
  }
  return EXIT_FAILURE;
}

}  // namespace fovea::cli
