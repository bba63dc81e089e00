#include "client/capture/crash_watch.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "client/capture/camera_error.h"

namespace fovea::capture {
namespace {

constexpr std::array kPassedOn{SIGINT, SIGTERM, SIGHUP};
constexpr std::array kCrashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

std::atomic<pid_t> child = 0;
static_assert(std::atomic<pid_t>::is_always_lock_free);

void PassOn(int number) { kill(child, number); }

void PassSignalsOn() {
  struct sigaction action {};
  action.sa_handler = PassOn;
  for (const int number : kPassedOn) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);
  }
}

// As waitpid says it.
int StatusOfChild() {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

[[noreturn]] void EndBySignal(int number) {
  signal(number, SIG_DFL);
  raise(number);
  std::_Exit(128 + number);  // where it is blocked
}

}  // namespace

void GoOnWatched(const std::string& recording) {
  // What comes meanwhile is the child's, once it is there.
  sigset_t passed_on, before;
  sigemptyset(&passed_on);
  for (const int number : kPassedOn) sigaddset(&passed_on, number);
  sigprocmask(SIG_BLOCK, &passed_on, &before);
  const pid_t parent = getpid(), forked = fork();
  if (forked > 0) {
    child = forked;
    PassSignalsOn();
  } else if (forked == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) std::_Exit(EXIT_FAILURE);  // it was killed before that
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  if (forked <= 0) return;  // where there can be no child, it is played all the same

  const int status = StatusOfChild();
  if (WIFEXITED(status)) std::exit(WEXITSTATUS(status));
  const int number = WTERMSIG(status);
  if (std::find(kCrashes.begin(), kCrashes.end(), number) == kCrashes.end()) EndBySignal(number);
  throw CameraError(recording + " is damaged: the reader of OpenNI2 crashed at it (" +
                    strsignal(number) + ")");
}

}  // namespace fovea::capture
