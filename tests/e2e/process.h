// Runs the real executables.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace fovea::testing {

// From when on something is held to hang.
constexpr std::chrono::minutes kPatience{1};

struct Finished {
  int exit_code = -1;  // -1 = killed by a signal
  std::string out, err;
};

// A child process. Its stdout and stderr go to files, which are read when it has ended.
class Process {
 public:
  // `arguments[0]` is the executable's path, or its name where PATH leads to it. `err` is where
  // stderr goes instead of the file, which is empty then.
  explicit Process(const std::vector<std::string>& arguments, int err = -1);
  // Kills the child where it still runs.
  ~Process();

  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  // Returns false where the child has ended or reads no more; SIGPIPE must be ignored for that.
  bool WriteLine(const std::string& line) const;
  // The next line of stdout, without its end; empty when the child closed it.
  std::string ReadLine();
  pid_t pid() const { return pid_; }
  // Returns once stderr holds `text`; throws where the child has ended without it.
  void AwaitError(const std::string& text) const;
  void Signal(int number) const;
  Finished Wait();

 private:
  pid_t pid_ = -1;
  int in_ = -1;              // writing end of the child's stdin
  int out_ = -1, err_ = -1;  // reading ends of the child's pipes; err_ is a file
};

// Runs to the end.
Finished Execute(const std::vector<std::string>& arguments);

}  // namespace fovea::testing
