#include "client/cli/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <future>
#include <iostream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "client/bundle/comparison.h"
#include "client/cli/files.h"
#include "client/cli/frame_list.h"
#include "client/cli/json.h"
#include "client/cli/output_check.h"
#include "client/cli/outputs.h"
#include "client/cli/progress.h"
#include "client/cli/report.h"
#include "client/cli/resume.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

// What came of a frame.
struct Outcome {
  std::string failure;  // empty = none
  int num_objects = 0;
  std::vector<std::string> notes;
  std::string json_line;
  bool is_of_all = false;  // the failure is no matter of this frame
  cv::Size size = {};      // of the image that was answered
};

// How the answer compares with that of a frame that was sent before.
std::vector<std::string> ComparisonOf(const FrameFiles& files, const v1::Detections& found) {
  if (!files.sent_before) return {};
  const SentBefore& before = *files.sent_before;
  if (!before.answer) return {"it was refused then"};
  return {bundle::CompareAnswers(*before.answer, found, before.request.options())};
}

void WriteComparable(const Outputs& outputs, const FrameFiles& files, const v1::Detections& found) {
  if (!files.sent_before) return;
  const std::string path =
      outputs.json.substr(0, outputs.json.size() - std::string(".json").size());
  WriteFile(path + "_answer.pb",
            bundle::BytesOf(bundle::Comparable(found, files.sent_before->request.options(),
                                               /*with_times=*/true)));
}

// What all frames have in common.
struct Run {
  PatientServer& server;
  const Batch& batch;
  const FrameSettings settings;
};

// Of what flags say, and no frame. The size of voxels is also named for a frame that is too much
// for the method.
bool IsOfAllFrames(const client::RpcError& error, const Run& run) {
  if (error.code() != grpc::StatusCode::INVALID_ARGUMENT || run.batch.sent_before) return false;
  const std::string& field = error.field();
  if (field == "options.parameters[voxels.size_m]") return false;
  return field.starts_with("options.") || field.starts_with("frame.gravity") ||
         field.starts_with("frame.camera_pose");
}

// Whoever finds NAME.json finds all of it, and all other files.
void WriteFiles(Outputs outputs, const FrameFiles& files, const FrameSettings& settings,
                const v1::DetectRequest& request, const v1::Detections& found) {
  if (outputs.json == kStandardOutput) return;
  fs::remove(outputs.json);  // of a run before
  WriteComparable(outputs, files, found);
  const std::string json = std::exchange(outputs.json, outputs.json + ".part");
  WriteOutputs(outputs, files, settings, request, found);
  fs::rename(outputs.json, json);
}

// What comes with a folder may be pipes, which would be waited for, and devices without an end.
void RequireFiles(const FrameFiles& files) {
  for (const std::string& path : {files.color_path, files.depth_path}) {
    if (!fs::exists(path)) throw std::runtime_error("no " + path + ", counts as failed");
    if (!fs::is_regular_file(path)) throw std::runtime_error(path + " is no regular file");
  }
}

Outcome DetectFrame(const Run& run, const FrameFiles& files) {
  try {
    if (!files.read_depth && !files.sent_before) RequireFiles(files);
    const Outputs outputs = OutputsOf(files.id, run.batch);
    const v1::DetectRequest request = MakeRequest(files, run.settings);
    const v1::DetectResponse response = run.server.Ask(request);
    const v1::Detections& found = response.detections();
    CheckSize(run.settings, found);
    WriteFiles(outputs, files, SettingsFor(files, run.settings), request, found);
    std::vector<std::string> notes = ComparisonOf(files, found);
    const auto& reasons = found.diagnostics().messages();
    notes.insert(notes.end(), reasons.begin(), reasons.end());
    return {{},
            found.objects_size(),
            std::move(notes),
            run.batch.json_lines ? JsonLine(outputs, request, found) : "",
            /*is_of_all=*/false,
            {static_cast<int>(found.width()), static_cast<int>(found.height())}};
  } catch (const client::RpcError& error) {
    return {run.server.Words(error), 0, {}, {}, IsOfAllFrames(error, run)};
  } catch (const ErrorOfAllFrames& error) {
    return {error.what(), 0, {}, {}, /*is_of_all=*/true};
  } catch (const ServerHangs& error) {
    const char* rest =
        run.batch.output.empty() ? "" : "; --resume asks for the frames that are left";
    return {error.what() + std::string(rest), 0, {}, {}, /*is_of_all=*/true};
  } catch (const std::exception& error) {
    return {error.what(), 0, {}, {}, /*is_of_all=*/false};
  }
}

class Printer {
 public:
  Printer(std::size_t num_frames, bool json_lines)
      : progress_(num_frames, json_lines ? Progress::Stream::kError : Progress::Stream::kOut),
        text_(json_lines ? std::cerr : std::cout) {}

  void Print(const FrameFiles& files, const Outcome& outcome) {
    if (!outcome.failure.empty()) {
      ++num_failed_;
      progress_.Complain("fovea: " + files.id + ": " + outcome.failure);
      progress_.Advance(files.id + ": failed");
      return;
    }
    ++num_done_;
    num_objects_ += outcome.num_objects;
    if (!outcome.json_line.empty() && !(std::cout << outcome.json_line << std::flush)) {
      throw std::runtime_error("standard output cannot be written");  // the rest would be lost
    }
    progress_.Advance(files.id + ": " + NumObjects(outcome.num_objects), outcome.notes);
  }

  // Once, for frames whose intrinsics nobody checks by their size.
  void NoteOtherSize(const FrameFiles& files, const cv::Size& size) {
    if (size.empty() || size == size_ || other_size_noted_) return;
    other_size_noted_ = !size_.empty();
    if (!other_size_noted_) {
      size_ = size;
      return;
    }
    progress_.Complain(fmt::format(
        "note: {} has {}x{}, frames before it {}x{}: --intrinsics without a size are used for all, "
        "and are those of one",
        files.id, size.width, size.height, size_.width, size_.height));
  }

  // Returns whether nothing failed.
  bool Finish(std::size_t num_before) {
    progress_.Finish();
    text_ << num_done_ << " of " << num_done_ + num_failed_ << " frames done, "
          << NumObjects(num_objects_) << ", " << num_failed_ << " failed";
    if (num_before > 0) text_ << "; " << num_before << " were done before";
    text_ << std::endl;
    return num_failed_ == 0;
  }

 private:
  Progress progress_;
  std::ostream& text_;
  std::size_t num_done_ = 0, num_failed_ = 0;
  int num_objects_ = 0;
  cv::Size size_;
  bool other_size_noted_ = false;
};

// What the flags do not say of the cameras, the folder does.
void SetDepthFrom(const FrameList& list, const Batch& batch, FrameSettings* settings) {
  settings->depth_unit_m = batch.depth_unit_m.value_or(list.depth_unit_m);
  if (!list.captured) return;
  const bool has_camera = list.captured->depth_camera && !settings->depth_camera;
  if (has_camera) settings->depth_camera = list.captured->depth_camera;
  if (!batch.depth_unit_m) PrintNote("depth unit from " + list.captured->path);
  if (has_camera) PrintNote("depth camera from " + list.captured->path);
}

}  // namespace

bool DetectFolder(PatientServer& server, Batch batch, FrameSettings settings) {
  FrameList list = std::move(batch.list);
  for (const std::string& note : list.notes) PrintNote(note);
  if (const std::size_t renamed = NameApart(list.frames); renamed > 0) {
    PrintNote(fmt::format("frames whose name is taken: {}; they are called NAME_2, NAME_3, ...",
                          renamed));
  }
  SetDepthFrom(list, batch, &settings);
  const auto request_for = batch.sent_before ? RequestForPictures : RequestFor;
  request_for(OutputsOf("any", batch), &settings.options);
  if (!batch.output.empty()) {
    PrepareFolder(batch.input, list.frames, batch.output);
    SaveRequest(batch, settings);
  }
  const std::size_t num_before = LeaveOutDone(batch, &list.frames);
  const Run run{server, batch, std::move(settings)};
  if (!list.frames.empty()) server.Await();
  const std::size_t jobs = list.frames.empty() ? 0 : server.MostAtOnce(batch.jobs);
  Printer printer(list.frames.size(), batch.json_lines);
  std::deque<std::future<Outcome>> in_flight;
  std::size_t next = 0;
  for (const FrameFiles& files : list.frames) {
    for (; next < list.frames.size() && in_flight.size() < jobs; ++next) {
      in_flight.push_back(std::async(std::launch::async, DetectFrame, std::cref(run),
                                     std::cref(list.frames[next])));
    }
    const Outcome outcome = in_flight.front().get();
    in_flight.pop_front();
    if (outcome.is_of_all) throw std::runtime_error(outcome.failure);
    printer.Print(files, outcome);
    if (run.settings.size.empty() && !batch.sent_before) {
      printer.NoteOtherSize(files, outcome.size);
    }
  }
  return printer.Finish(num_before);
}

}  // namespace fovea::cli
