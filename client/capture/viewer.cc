#include "client/capture/viewer.h"

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
  if (picture) {
    cv::cvtColor(picture->color, color_, cv::COLOR_RGB2BGR);
    depth_ = DrawDepth(picture->depth, picture->depth_unit_m);
  }
  if (auto overlay = overlays_.TryTake()) cv::resize(*overlay, overlay_, color_.size());
  if (!color_.empty()) {
    cv::Mat panels;
    cv::hconcat(
        std::vector<cv::Mat>{color_, overlay_.size() == color_.size() ? overlay_ : color_, depth_},
        panels);
    cv::imshow(kTitle, panels);
  }
  const int key = cv::waitKey(1);
  constexpr int kEscape = 27;
  return key != 'q' && key != kEscape &&
         (color_.empty() || cv::getWindowProperty(kTitle, cv::WND_PROP_VISIBLE) != 0);
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
