#include "core/objects/color_names.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

#include "core/types/lab.h"

namespace fovea {
namespace {

// Hues in degrees, from red over yellow, green and blue.
ColorName NameOfRed(double lightness, double chroma, double hue) {
  if (lightness >= 41 + 0.6 * hue) return ColorName::kPink;
  if (hue >= 27) return chroma < 54 ? ColorName::kBrown : ColorName::kRed;
  if (chroma >= 33) return ColorName::kRed;
  return hue >= 10 ? ColorName::kBrown : ColorName::kPurple;
}

ColorName NameOfYellow(double lightness, double chroma, double hue) {
  if (hue >= 99 && lightness < 75) return ColorName::kGreen;
  const bool is_brown = lightness < 63 || (chroma < 46 && lightness < 75);
  return is_brown ? ColorName::kBrown : ColorName::kYellow;
}

ColorName NameOf(double lightness, double chroma, double hue) {
  if (lightness < 8) return ColorName::kBlack;
  if (chroma < 16) {
    if (lightness < 22) return ColorName::kBlack;
    return lightness > 85 ? ColorName::kWhite : ColorName::kGray;
  }
  if (hue < 48) return NameOfRed(lightness, chroma, hue);
  if (hue < 75) {
    const bool is_brown = lightness < 42 || (chroma < 58 && lightness < 75);
    return is_brown ? ColorName::kBrown : ColorName::kOrange;
  }
  if (hue < 115) return NameOfYellow(lightness, chroma, hue);
  if (hue < 166) return ColorName::kGreen;
  if (hue < 309) return ColorName::kBlue;
  return hue >= 328 && lightness >= 55 ? ColorName::kPink : ColorName::kPurple;
}

ColorName NameOfLab(const cv::Vec3b& lab) {
  const double lightness = lab[0] / 2.55, a = lab[1] - 128.0, b = lab[2] - 128.0;
  const double hue = std::atan2(b, a) * 180 / std::numbers::pi;
  return NameOf(lightness, std::hypot(a, b), hue < 0 ? hue + 360 : hue);
}

constexpr int kBits = 5, kShift = 8 - kBits;  // of a channel

std::size_t IndexOf(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  return (static_cast<std::size_t>(r >> kShift) << (2 * kBits)) |
         (static_cast<std::size_t>(g >> kShift) << kBits) | static_cast<std::size_t>(b >> kShift);
}

// The name of the middle of each step of colours.
std::vector<ColorName> MakeTable() {
  constexpr int kSteps = 1 << kBits;
  cv::Mat colors(kSteps * kSteps, kSteps, CV_8UC3);
  for (int rg = 0; rg < colors.rows; ++rg) {
    for (int b = 0; b < kSteps; ++b) {
      constexpr int kMiddle = 1 << (kShift - 1);
      const auto channel = [](int step) {
        return static_cast<std::uint8_t>((step << kShift) + kMiddle);
      };
      colors.at<cv::Vec3b>(rg, b) = {channel(rg / kSteps), channel(rg % kSteps), channel(b)};
    }
  }
  const cv::Mat lab = LabOf(colors);
  std::vector<ColorName> names;
  names.reserve(lab.total());
  for (int row = 0; row < lab.rows; ++row) {
    for (int b = 0; b < kSteps; ++b) names.push_back(NameOfLab(lab.at<cv::Vec3b>(row, b)));
  }
  return names;
}

const std::vector<ColorName>& Table() {
  static const std::vector<ColorName> table = MakeTable();
  return table;
}

struct Sums {
  std::size_t count = 0;
  std::array<std::size_t, 3> color{};
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

ColorPart PartOf(ColorName name, const Sums& sums, std::size_t total) {
  const auto count = static_cast<double>(sums.count);
  ColorPart part;
  part.name = name;
  part.share = static_cast<float>(count / static_cast<double>(total));
  for (std::size_t i = 0; i < 3; ++i) {
    part.mean[i] =
        static_cast<std::uint8_t>(std::lround(static_cast<double>(sums.color[i]) / count));
  }
  part.centroid = (sums.position / count).cast<float>();
  return part;
}

}  // namespace

ColorName NameOfColor(const std::array<std::uint8_t, 3>& rgb) {
  const cv::Mat color(1, 1, CV_8UC3, cv::Scalar(rgb[0], rgb[1], rgb[2]));
  return NameOfLab(LabOf(color).at<cv::Vec3b>(0, 0));
}

std::vector<ColorPart> ColorPartsOf(const std::vector<ColoredPoint>& cloud) {
  constexpr float kMinShare = 0.125F;
  const std::vector<ColorName>& table = Table();
  std::array<Sums, kNumColorNames> by_name;
  for (const ColoredPoint& point : cloud) {
    Sums& sums = by_name[static_cast<std::size_t>(table[IndexOf(point.r, point.g, point.b)])];
    ++sums.count;
    sums.color[0] += point.r;
    sums.color[1] += point.g;
    sums.color[2] += point.b;
    sums.position += Eigen::Vector3d(point.x, point.y, point.z);
  }
  std::vector<ColorPart> parts;
  parts.reserve(kNumColorNames);
  for (std::size_t i = 0; i < kNumColorNames; ++i) {
    if (by_name[i].count == 0) continue;
    parts.push_back(PartOf(static_cast<ColorName>(i), by_name[i], cloud.size()));
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const ColorPart& a, const ColorPart& b) { return a.share > b.share; });
  const auto small = std::find_if(parts.begin(), parts.end(),
                                  [](const ColorPart& part) { return part.share < kMinShare; });
  parts.erase(small == parts.begin() && !parts.empty() ? small + 1 : small, parts.end());
  return parts;
}

}  // namespace fovea
