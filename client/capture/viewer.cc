#include "client/capture/viewer.h"

#include <algorithm>
#include <cstdlib>
#include <opencv2/highgui.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "client/capture/trial.h"

namespace fovea::capture {
namespace {

constexpr const char* kTitle = "fovea-capture (q closes)";

// The display that the window would open on; empty = none.
std::string DisplayName() {
  for (const char* name : {"QT_QPA_PLATFORM", "WAYLAND_DISPLAY", "DISPLAY"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') return std::string(name) + "=" + value;
  }
  return "";
}

void OpenWindow() { cv::namedWindow(kTitle, cv::WINDOW_NORMAL | cv::WINDOW_KEEPRATIO); }

}  // namespace

Viewer::Viewer() {
  const std::string display = DisplayName();
  if (display.empty()) {
    throw std::runtime_error(
        "--view needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set; --save DIR writes "
        "pictures instead");
  }
  // Qt and GTK, which OpenCV may have, end the program where the display cannot be reached.
  constexpr unsigned kPatience_s = 10;
  if (!SucceedsInAChild(OpenWindow, kPatience_s)) {
    throw std::runtime_error("--view: no window opens on " + display +
                             ": is the display there, and may this user open it (xauth)? --save "
                             "DIR writes pictures instead");
  }
  OpenWindow();
}

Viewer::~Viewer() { cv::destroyAllWindows(); }

bool Viewer::Refresh(const std::optional<Picture>& picture) {
  auto overlay = overlays_.TryTake();
  if (picture || overlay) {
    const Panels panels = PanelsOf(picture ? picture->color.size() : overlay->size());
    if (window_.size() != panels.window) {
      window_ = cv::Mat::zeros(panels.window, CV_8UC3);
      cv::resizeWindow(kTitle, panels.window);
      answered_ = false;
    }
    if (picture) DrawLive(*picture, panels);
    if (overlay) {
      cv::resize(*overlay, window_(panels.answer), panels.answer.size(), 0, 0, cv::INTER_LINEAR);
      answered_ = true;
    }
    cv::imshow(kTitle, window_);
  }
  const int key = cv::waitKey(1);
  constexpr int kEscape = 27;
  return key != 'q' && key != kEscape &&
         (window_.empty() || cv::getWindowProperty(kTitle, cv::WND_PROP_VISIBLE) != 0);
}

// Made small before anything else is done with it.
void Viewer::DrawLive(const Picture& picture, const Panels& panels) {
  cv::Mat small;
  if (!answered_) {  // there is nothing to show of it yet
    cv::resize(picture.color, small, panels.answer.size(), 0, 0, cv::INTER_LINEAR);
    cv::cvtColor(small, window_(panels.answer), cv::COLOR_RGB2BGR);
  }
  cv::resize(picture.color, small, panels.color.size(), 0, 0, cv::INTER_LINEAR);
  cv::cvtColor(small, window_(panels.color), cv::COLOR_RGB2BGR);
  cv::resize(picture.depth, small, panels.depth.size(), 0, 0, cv::INTER_NEAREST);
  DrawDepth(small, picture.depth_unit_m).copyTo(window_(panels.depth));
}

Panels PanelsOf(const cv::Size& frame) {
  constexpr int kWidth = 1280, kSide = kWidth / 3;
  const int side_height = std::max(1, kSide * frame.height / frame.width);
  return {.window = {kWidth, 2 * side_height},
          .answer = {0, 0, kWidth - kSide, 2 * side_height},
          .color = {kWidth - kSide, 0, kSide, side_height},
          .depth = {kWidth - kSide, side_height, kSide, side_height}};
}

cv::Mat DrawDepth(const cv::Mat& depth, double unit_m) {
  constexpr double kFar_m = 4;
  cv::Mat near, drawn;
  depth.convertTo(near, CV_8U, -255 * unit_m / kFar_m, 255);
  cv::applyColorMap(near, drawn, cv::COLORMAP_TURBO);
  drawn.setTo(cv::Scalar::all(0), depth == 0);
  return drawn;
}

}  // namespace fovea::capture
