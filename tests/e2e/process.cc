#include "tests/e2e/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <utility>

namespace fovea::testing {
namespace {

std::string ReadAll(int descriptor) {
  std::string text;
  char buffer[4096];
  for (ssize_t size; (size = read(descriptor, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(size));
  }
  return text;
}

// A nameless file: a child that writes much to stderr never waits for a reader.
int TemporaryFile() {
  char path[] = "/tmp/fovea_e2e_XXXXXX";
  const int descriptor = mkstemp(path);
  unlink(path);
  return descriptor;
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, int err) {
  int pipe_ends[2], input_ends[2];
  if (pipe2(pipe_ends, O_CLOEXEC) != 0 || pipe2(input_ends, O_CLOEXEC) != 0) {
    throw std::runtime_error("no pipe");
  }
  out_ = pipe_ends[0];
  in_ = input_ends[1];
  err_ = TemporaryFile();

  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input_ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err >= 0 ? err : err_, STDERR_FILENO);
  const int error = posix_spawnp(&pid_, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(pipe_ends[1]);
  close(input_ends[0]);
  if (error != 0) throw std::runtime_error("cannot start " + arguments[0]);
}

Process::~Process() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  if (in_ >= 0) close(in_);
  close(out_);
  close(err_);
}

bool Process::WriteLine(const std::string& line) const {
  const std::string text = line + '\n';
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t size = write(in_, text.data() + done, text.size() - done);
    if (size < 0) return false;
    done += static_cast<std::size_t>(size);
  }
  return true;
}

std::string Process::ReadLine() {
  std::string line;
  for (char c; read(out_, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

void Process::AwaitError(const std::string& text) const {
  std::string seen;
  while (true) {
    siginfo_t end{};  // asked for first: what is read then is all
    waitid(P_PID, static_cast<id_t>(pid_), &end, WEXITED | WNOHANG | WNOWAIT);
    char buffer[4096];
    for (ssize_t size;
         (size = pread(err_, buffer, sizeof buffer, static_cast<off_t>(seen.size()))) > 0;) {
      seen.append(buffer, static_cast<std::size_t>(size));
    }
    if (seen.find(text) != std::string::npos) return;
    if (end.si_pid != 0) throw std::runtime_error("it has not said " + text + " but: " + seen);
    std::this_thread::yield();
  }
}

void Process::Signal(int number) const { kill(pid_, number); }

Finished Process::Wait() {
  Finished finished;
  close(std::exchange(in_, -1));
  finished.out = ReadAll(out_);
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  lseek(err_, 0, SEEK_SET);
  finished.err = ReadAll(err_);
  return finished;
}

Finished Execute(const std::vector<std::string>& arguments) { return Process(arguments).Wait(); }

}  // namespace fovea::testing
