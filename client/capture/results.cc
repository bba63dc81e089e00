#include "client/capture/results.h"

#include <grpcpp/support/status_code_enum.h>

#include <cstdio>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "client/capture/encoding.h"
#include "client/capture/intrinsics.h"
#include "client/cli/capture_file.h"
#include "client/cli/files.h"
#include "client/cli/json.h"
#include "client/cli/labels.h"
#include "client/cli/overlay/overlay.h"
#include "client/cli/report.h"
#include "flags/one_line.h"

namespace fovea::capture {
namespace {

std::string TextOf(const v1::FrameError& error) {
  const std::string text = flags::OneLine(error.message());
  return error.request_id().empty() ? text : text + " (request " + error.request_id() + ")";
}

// "000012  5 objects  143 ms, 3 dropped by the server".
std::string Line(const Result& result, double latency_ms) {
  const v1::DetectStreamResponse& response = result.response;
  char time[48];
  std::snprintf(time, sizeof time, "  %.0f ms", latency_ms);
  std::string line = response.frame_id() + "  ";
  line += response.has_error() ? "failed: " + TextOf(response.error())
                               : cli::NumObjects(response.detections().objects_size());
  line += time;
  if (response.dropped() > 0) {
    line += ", " + std::to_string(response.dropped()) + " dropped by the server";
  }
  if (result.lost > 0) {
    line += ", " + std::to_string(result.lost) + " lost with the connection";
  }
  return line;
}

bool IsAbout(const std::string& field, const std::string& text) {
  return text == field || text.starts_with(field + ":");
}

// What is wrong with the bytes of an image is wrong with that one; all else that frames of a run
// say (options, gravity, cameras, sizes, the depth unit) is the same in every frame.
void EndIfHopeless(const v1::FrameError& error) {
  if (error.code() != grpc::StatusCode::INVALID_ARGUMENT) return;
  const std::string& text = error.field().empty() ? error.message() : error.field();
  if (IsAbout("frame.color.data", text) || IsAbout("frame.depth.data", text)) return;
  // Also of a frame that is too much for the method, as noise is.
  if (IsAbout("options.parameters[voxels.size_m]", text)) return;
  throw std::runtime_error(TextOf(error));
}

void SaveFrame(const std::string& prefix, const Picture& picture, const v1::Detections& detections,
               const v1::Frame& frame, const cv::Mat& color, const cv::Mat& overlay) {
  cli::WriteImage(prefix + "_color.png", color);
  cli::WriteImage(prefix + "_depth.png", picture.depth);
  cli::WriteImage(prefix + "_overlay.jpg", overlay);
  cli::WriteImage(prefix + ".png", cli::LabelImage(detections));
  cli::WriteFile(prefix + ".json", cli::ToJson(detections, frame));
}

// Half a frame, as a full disk leaves it, is none to whoever reads the folder.
void RemoveFrame(const std::string& prefix) {
  std::error_code ignored;
  for (const char* ending : {"_color.png", "_depth.png", "_overlay.jpg", ".png", ".json"}) {
    std::filesystem::remove(prefix + ending, ignored);
  }
}

}  // namespace

Results::Results(std::string save_folder, v1::Frame cameras, Viewer* viewer, std::ostream& out)
    : save_folder_(std::move(save_folder)),
      cameras_(std::move(cameras)),
      viewer_(viewer),
      out_(out) {
  saved_cameras_ = save_folder_.empty();
}

void Results::RequestFor(v1::DetectOptions* options) const { options->set_return_masks(Draws()); }

void Results::Take(const Result& result, Tally& tally) {
  const v1::DetectStreamResponse& response = result.response;
  const std::chrono::duration<double, std::milli> latency =
      std::chrono::steady_clock::now() - result.picture.arrived;
  tally.Gone(response.dropped(), result.lost);
  tally.Count(response.has_error(),
              static_cast<std::uint64_t>(response.detections().objects_size()), latency.count());
  const bool is_too_late = Draws() && !response.has_error() && result.picture.color.empty();
  out_ << Line(result, latency.count()) << (is_too_late ? ", too late to be drawn" : "")
       << std::endl;
  if (response.has_error()) EndIfHopeless(response.error());
  if (response.has_error()) return;
  PrintNotes(response.detections());
  out_ << busy_watch_.Take(response.detections()) << std::flush;
  if (!Draws() || is_too_late) return;

  cv::Mat color;
  cv::cvtColor(result.picture.color, color, cv::COLOR_RGB2BGR);
  const cv::Mat overlay = cli::DrawOverlay(color, cameras_.intrinsics(), response.detections());
  if (!save_folder_.empty()) Save(result.picture, response.detections(), color, overlay);
  if (viewer_ != nullptr) viewer_->SetOverlay(overlay);
}

// A camera that sees nothing would repeat itself thirty times a second; only the counts differ.
void Results::PrintNotes(const v1::Detections& detections) {
  std::string notes;
  for (const std::string& message : detections.diagnostics().messages()) {
    notes += "note: " + message + "\n";
  }
  std::string without_numbers = notes;
  std::erase_if(without_numbers, [](char c) { return c >= '0' && c <= '9'; });
  if (without_numbers != std::exchange(last_notes_, without_numbers)) out_ << notes << std::flush;
}

void Results::Save(const Picture& picture, const v1::Detections& detections, const cv::Mat& color,
                   const cv::Mat& overlay) {
  v1::Frame frame = cameras_;
  frame.mutable_depth()->set_unit_m(picture.depth_unit_m);
  if (!std::exchange(saved_cameras_, true)) {
    SaveIntrinsics(save_folder_ + "/intrinsics.json", cameras_.intrinsics(), color.size());
    cli::WriteCaptureFile(save_folder_, frame);
  }
  const std::string prefix = save_folder_ + "/" + FrameName(picture.number);
  try {
    SaveFrame(prefix, picture, detections, frame, color, overlay);
  } catch (const std::exception&) {
    RemoveFrame(prefix);
    throw;
  }
}

}  // namespace fovea::capture
