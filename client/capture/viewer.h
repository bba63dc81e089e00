#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "client/capture/latest.h"
#include "client/capture/picture.h"

namespace fovea::capture {

// Where what is in the window, 1280 pixels wide: the answer large, beside it colour and depth.
struct Panels {
  cv::Size window;
  cv::Rect answer, color, depth;
};

Panels PanelsOf(const cv::Size& frame);

// The live window: the last answer drawn on its own frame; colour and depth as they come.
class Viewer {
 public:
  // Throws std::runtime_error where there is no display. Call it before threads start.
  Viewer();
  ~Viewer();

  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  // From any thread.
  void SetOverlay(cv::Mat overlay) { overlays_.Put(std::move(overlay)); }

  // From the thread that made the viewer, often: draws, and serves the window. False once a person
  // closed it (q or Escape).
  bool Refresh(const std::optional<Picture>& picture);

 private:
  void DrawLive(const Picture& picture, const Panels& panels);

  Latest<cv::Mat> overlays_;
  cv::Mat window_;         // CV_8UC3, B first
  bool answered_ = false;  // the window shows an answer
};

// Near = warm, far (4 m) = cold, not measured = black; CV_8UC3, B first.
cv::Mat DrawDepth(const cv::Mat& depth, double unit_m);

}  // namespace fovea::capture
