#include "client/cli/progress.h"

#include <unistd.h>

#include <iostream>

#include "flags/one_line.h"

namespace fovea::cli {
namespace {

constexpr const char* kClearLine = "\r\x1B[K";

}  // namespace

void PrintNote(const std::string& text) { std::cerr << "note: " << flags::OneLine(text) << '\n'; }

Progress::Progress(std::size_t total, Stream stream)
    : total_(total),
      out_(stream == Stream::kOut ? std::cout : std::cerr),
      on_terminal_(isatty(stream == Stream::kOut ? STDOUT_FILENO : STDERR_FILENO) != 0) {}

void Progress::DrawBar(const std::string& text) const {
  constexpr std::size_t kWidth = 30;
  const std::size_t filled = total_ == 0 ? kWidth : kWidth * done_ / total_;
  out_ << kClearLine << '[' << std::string(filled, '#') << std::string(kWidth - filled, '.') << "] "
       << done_ << '/' << total_ << "  " << text << std::flush;
}

void Progress::Advance(const std::string& what, const std::vector<std::string>& notes) {
  const std::string text = flags::OneLine(what);  // names of files are in it
  ++done_;
  if (!on_terminal_) {
    out_ << done_ << '/' << total_ << "  " << text << '\n';
  } else if (!notes.empty()) {
    out_ << kClearLine << text << '\n';
  }
  for (const std::string& note : notes) out_ << "  note: " << note << '\n';
  if (on_terminal_) DrawBar(text);
  out_ << std::flush;
}

void Progress::Complain(const std::string& text) {
  if (on_terminal_) out_ << kClearLine << std::flush;
  std::cerr << flags::OneLine(text) << std::endl;
}

void Progress::Finish() {
  if (on_terminal_) out_ << std::endl;
}

}  // namespace fovea::cli
