// fovea-capture: from an RGB-D camera to a fovea server.
#include "client/capture/command_line.h"

int main(int argc, char** argv) { return fovea::capture::RunCommandLine(argc, argv); }
