#include "client/cli/overlay/palette.h"

#include <array>

namespace fovea::cli {
namespace {

struct Rgb {
  int red, green, blue;
};

// Sasha Trubetskoy's list of simple, distinct colours, without those too dark or too grey to
// stand out on a photograph.
constexpr std::array<Rgb, 16> kColors{{{230, 25, 75},
                                       {60, 180, 75},
                                       {255, 225, 25},
                                       {0, 130, 200},
                                       {245, 130, 48},
                                       {145, 30, 180},
                                       {70, 240, 240},
                                       {240, 50, 230},
                                       {210, 245, 60},
                                       {250, 190, 212},
                                       {0, 128, 128},
                                       {220, 190, 255},
                                       {170, 110, 40},
                                       {255, 250, 200},
                                       {170, 255, 195},
                                       {255, 215, 180}}};

}  // namespace

cv::Scalar ColorOf(std::uint32_t label) {
  const Rgb& color = kColors[(label - 1) % kColors.size()];
  return cv::Scalar(color.blue, color.green, color.red);
}

cv::Scalar TextColorOn(const cv::Scalar& background) {
  const double luma = 0.114 * background[0] + 0.587 * background[1] + 0.299 * background[2];
  return luma > 140 ? cv::Scalar(0, 0, 0) : cv::Scalar(255, 255, 255);
}

}  // namespace fovea::cli
