#include "core/objects/color_names.h"

#include <gmock/gmock.h>

namespace fovea {
namespace {

using enum ColorName;
using Rgb = std::array<std::uint8_t, 3>;

TEST(ColorNames, CallsColorsAsPeopleDo) {
  // Most frequent answers of the XKCD survey (Munroe 2010), and what is without doubt.
  const std::vector<std::pair<Rgb, ColorName>> colors = {
      {{0, 0, 0}, kBlack},        {{146, 149, 145}, kGray},   {{255, 255, 255}, kWhite},
      {{229, 0, 0}, kRed},        {{249, 115, 6}, kOrange},   {{255, 255, 20}, kYellow},
      {{21, 176, 26}, kGreen},    {{3, 67, 223}, kBlue},      {{126, 30, 156}, kPurple},
      {{255, 129, 192}, kPink},   {{101, 55, 0}, kBrown},     {{149, 208, 252}, kBlue},
      {{132, 0, 0}, kRed},        {{3, 53, 0}, kGreen},       {{199, 159, 239}, kPurple},
      {{255, 121, 108}, kPink},   {{173, 129, 80}, kBrown},   {{217, 84, 77}, kRed},
      {{255, 177, 109}, kOrange}, {{255, 254, 122}, kYellow}, {{7, 13, 13}, kBlack},
      {{197, 201, 199}, kGray},   {{89, 101, 109}, kGray},    {{150, 249, 123}, kGreen},
  };
  for (const auto& [rgb, name] : colors) {
    EXPECT_EQ(NameOfColor(rgb), name) << int{rgb[0]} << ' ' << int{rgb[1]} << ' ' << int{rgb[2]};
  }
}

ColoredPoint Point(float x, const Rgb& rgb) { return {x, 0, 1, rgb[0], rgb[1], rgb[2]}; }

TEST(ColorNames, PartsComeByTheirShare) {
  std::vector<ColoredPoint> cloud;
  for (int i = 0; i < 60; ++i) cloud.push_back(Point(0.1F, {230, 5, 5}));
  for (int i = 0; i < 30; ++i) cloud.push_back(Point(0.2F, {10, 60, 220}));
  for (int i = 0; i < 10; ++i) cloud.push_back(Point(0.3F, {255, 255, 255}));  // too few
  const std::vector<ColorPart> parts = ColorPartsOf(cloud);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, kRed);
  EXPECT_FLOAT_EQ(parts[0].share, 0.6F);
  EXPECT_EQ(parts[0].mean, (Rgb{230, 5, 5}));
  EXPECT_TRUE(parts[0].centroid.isApprox(Eigen::Vector3f(0.1F, 0, 1)));
  EXPECT_EQ(parts[1].name, kBlue);
  EXPECT_FLOAT_EQ(parts[1].share, 0.3F);
}

TEST(ColorNames, ManyColorsHaveOneNameAtLeast) {
  const std::vector<Rgb> all = {{0, 0, 0},      {128, 128, 128}, {255, 255, 255}, {230, 5, 5},
                                {249, 115, 6},  {255, 255, 20},  {21, 176, 26},   {3, 67, 223},
                                {126, 30, 156}, {255, 129, 192}, {101, 55, 0}};
  std::vector<ColoredPoint> cloud;
  for (const Rgb& rgb : all) cloud.push_back(Point(0, rgb));
  cloud.push_back(Point(0, {101, 55, 0}));
  const std::vector<ColorPart> parts = ColorPartsOf(cloud);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].name, kBrown);
  EXPECT_TRUE(ColorPartsOf({}).empty());
}

}  // namespace
}  // namespace fovea
