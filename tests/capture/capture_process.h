// The real fovea-capture on the test camera, against the real server.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/e2e/process.h"
#include "tests/e2e/server_process.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {

using Environment = std::map<std::string, std::string>;

// What --save wrote about one frame, and which of the generated frames it is.
struct SavedFrame {
  std::string name;
  std::size_t generated = 0;  // index; depth travels without loss, so it is equal to the bit
  cv::Mat color, labels;      // color: R first
  std::string label_file;     // the bytes of NAME.png
  std::string json;           // NAME.json without names and times
};

class CaptureTest : public ::testing::Test {
 protected:
  CaptureTest();

  std::string At(const std::string& name) const { return folder_.At(name); }

  // fovea-capture with the test camera; it is ended after two minutes.
  std::vector<std::string> CommandLine(const std::vector<std::string>& arguments,
                                       const Environment& environment = {}) const;
  Finished Capture(const std::vector<std::string>& arguments,
                   const Environment& environment = {}) const;
  // The same on the server of this test, with the size of the generated frames.
  std::vector<std::string> Live(std::vector<std::string> arguments = {}) const;
  std::vector<std::string> Replay(const std::string& recording,
                                  std::vector<std::string> arguments = {}) const;
  std::vector<std::string> Record(const std::string& recording,
                                  std::vector<std::string> arguments = {}) const;

  // In the order of their names. Fails where one is none of the generated frames.
  std::vector<SavedFrame> Saved(const std::string& folder) const;

  // The next line that is no note on a busy machine.
  static std::string ReadAnswer(Process& capture);
  static void ExpectOneLineError(const Finished& finished, const std::string& text);

  const TemporaryFolder folder_;
  std::vector<scenes::LabelledFrame> frames_;  // what the camera serves, in turn
  ServerProcess server_;
};

// The number before `text` in the summary, as 12 of "12 sent".
int CountOf(const std::string& summary, const std::string& text);

}  // namespace fovea::testing
