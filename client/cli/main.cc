// fovea: command-line client of a fovea server.
#include "client/cli/command_line.h"

int main(int argc, char** argv) { return fovea::cli::RunCommandLine(argc, argv, FOVEA_VERSION); }
