#include "client/cli/steps.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "client/cli/cloud.h"
#include "client/cli/files.h"
#include "client/cli/overlay/overlay.h"
#include "client/cli/report.h"
#include "client/cli/step_pictures.h"

namespace fovea::cli {
namespace {

// Text in HTML: names come from the caller, messages from the server.
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{0}</title><style>
body {{ font: 16px/1.4 sans-serif; margin: 1em auto; max-width: 1500px; padding: 0 1em; }}
main {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(min(26em, 100%), 1fr)); gap: 1em; }}
figure {{ margin: 0; }} img {{ width: 100%; }} figcaption {{ margin: .2em 0 1em; }}
</style></head><body><h1>{0}</h1>
)";

// Collects the pictures as they are written.
class Page {
 public:
  explicit Page(std::string folder) : folder_(std::move(folder)) {}

  void Add(const std::string& name, const cv::Mat& picture, const std::string& caption) {
    WriteImage(folder_ + "/" + name, picture);
    figures_ += fmt::format(
        "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"\"></a><figcaption>{1}"
        "</figcaption></figure>\n",
        name, caption);
  }

  void Write(const std::string& title, const std::string& summary) const {
    WriteFile(folder_ + "/index.html", fmt::format(fmt::runtime(kHead), Escaped(title)) + "<pre>" +
                                           Escaped(summary) + "</pre>\n<main>\n" + figures_ +
                                           "</main></body></html>\n");
  }

 private:
  std::string folder_, figures_;
};

void AddSeen(Page& page, const cv::Mat& color, const std::vector<DepthPoint>& points,
             const cv::Mat& filled, const v1::Detections& detections) {
  page.Add("01_color.png", color, "Colour as sent.");
  page.Add("02_depth.png", DepthPicture(MeasuredDepth(points, color.size())),
           "Depth as measured: warm is near, black is nothing.");
  page.Add("03_depth_filled.png", DepthPicture(filled),
           "Depth with its holes filled by the mode of 25 pixels (section 1).");
  for (const v1::SaliencyMap& map : detections.saliency_maps()) {
    if (map.name() == "color") {
      page.Add("04_color_saliency.png", SaliencyPicture(map, color.size()),
               "Colour saliency (Algorithm 1; Fig. 2 c).");
    } else if (map.name() == "depth") {
      page.Add("05_depth_saliency.png", SaliencyPicture(map, color.size()),
               "Depth saliency (Fig. 2 d).");
    }
  }
}

void AddDecided(Page& page, const cv::Mat& color, const cv::Mat& filled,
                const FrameSettings& settings, const v1::Detections& detections) {
  const v1::Trace& trace = detections.trace();
  page.Add("06_seeds.png", SeedPicture(color, trace),
           "Seeds, and salient positions that did not become one, by why (Fig. 1 a).");
  page.Add("07_hypotheses.png", HypothesesPicture(color, filled, settings.intrinsics, trace),
           "Object hypotheses: the probability of Eq. 5 around the first seeds (Fig. 3).");
  page.Add("08_hypothesis_labels.png", LabelsPicture(color, trace.hypotheses()),
           "The hypothesis that won after the graph cut (Eq. 1; Fig. 4 b).");
  page.Add("09_segments.png", LabelsPicture(color, trace.segments()),
           "Segments before those of one object are joined.");
  page.Add("10_merged.png", LabelsPicture(color, trace.merged()),
           "And after (section 3.3; Fig. 4 c), before it is decided what is an object.");
  page.Add("11_objects.png", DrawOverlay(color, settings.intrinsics, detections),
           "The objects with their boxes and best grasps (Figs. 1 d, 7). Their tinted cloud is in "
           "<a href=\"12_cloud.ply\">12_cloud.ply</a> (Fig. 1 c).");
  if (detections.rejected().empty()) return;
  page.Add("13_rejected.png", RejectedPicture(color, detections),
           "What was considered and is not reported: the probability that it is an object, and "
           "below what speaks against it most.");
}

// The first of what is drawn in the picture of it.
std::string Rejected(const v1::Detections& detections) {
  constexpr int kMost = 20;
  std::string text;
  for (const v1::RejectedObject& rejected : detections.rejected()) {
    if (&rejected - &detections.rejected(0) == kMost) break;
    const v1::BoundingBox2D& box = rejected.bounding_box();
    text += fmt::format("not reported, {:.0f} %: {}x{} pixels at {}, {}; against it: {}\n",
                        100 * rejected.probability(), box.width(), box.height(), box.x(), box.y(),
                        rejected.reason());
  }
  return text;
}

// Salient positions are asked for by the paper, and where no surface was found.
std::string Seeds(const v1::Diagnostics& d) {
  if (d.seeds_from_color() + d.seeds_from_depth() == 0) {
    return fmt::format("{} seeds", d.num_seeds());
  }
  return fmt::format(
      "{} salient positions in colour, {} in depth: {} without depth, {} on the support, {} seeds",
      d.seeds_from_color(), d.seeds_from_depth(), d.seeds_without_depth(), d.seeds_on_support(),
      d.num_seeds());
}

std::string Summary(const v1::Detections& detections) {
  const v1::Diagnostics& d = detections.diagnostics();
  std::string text = fmt::format(
      "profile {}\n{} pixels, {} with depth, {} points\n"
      "{}\n{} voxels, {} segments, {} joined to another, {} no objects, {} too small\n{}\n",
      detections.profile(), d.num_pixels(), d.num_measured(), d.num_points(), Seeds(d),
      d.num_voxels(), d.num_segments(), d.num_merged(), d.segments_implausible(),
      d.segments_too_small(), NumObjects(detections.objects_size()));
  for (const std::string& message : d.messages()) text += message + "\n";
  return text + Rejected(detections);
}

}  // namespace

void WriteSteps(const std::string& folder, const cv::Mat& color, const cv::Mat& depth,
                const FrameSettings& settings, const v1::Detections& detections) {
  if (!detections.has_trace()) {
    throw std::runtime_error("--explain: the server is too old to tell its steps");
  }
  const std::vector<DepthPoint> points = PointsInColor(depth, settings, color.size());
  const cv::Mat filled = FilledDepth(detections.trace(), color.size());
  Page page(folder);
  AddSeen(page, color, points, filled, detections);
  AddDecided(page, color, filled, settings, detections);
  WriteFile(folder + "/12_cloud.ply", MakePly(TintedCloud(color, points, detections)));
  page.Write(detections.frame_id(), Summary(detections));
}

}  // namespace fovea::cli
