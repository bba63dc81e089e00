#include "client/observer/command_line.h"

int main(int argc, char** argv) { return fovea::observer::RunCommandLine(argc, argv); }
