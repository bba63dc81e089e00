#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace fovea::cli {

// A line "note: …" on stderr, before a run. Names of files and topics may hold any characters.
void PrintNote(const std::string& text);

// How far a run over many frames is: a bar that is drawn over itself on a terminal, else a line
// per frame.
class Progress {
 public:
  enum class Stream { kOut, kError };

  explicit Progress(std::size_t total, Stream stream = Stream::kOut);

  // One more frame is done; `text` says what came of it. Notes stand in lines of their own, beneath
  // what they are about, and stay above the bar.
  void Advance(const std::string& text, const std::vector<std::string>& notes = {});
  // A line on stderr that stays above the bar.
  void Complain(const std::string& text);
  // Leaves the bar behind.
  void Finish();

 private:
  void DrawBar(const std::string& text) const;

  const std::size_t total_;
  std::ostream& out_;
  const bool on_terminal_;
  std::size_t done_ = 0;
};

}  // namespace fovea::cli
