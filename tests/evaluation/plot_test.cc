#include "tests/evaluation/plot.h"

#include <gmock/gmock.h>

namespace fovea::evaluation {
namespace {

using testing::HasSubstr;

TEST(Plot, PutsPointsWhereTheyBelong) {
  // The frame is 290 × 250 with its corner at (60, 34).
  const std::string svg = DrawSvg({{.title = "P & R < 1",
                                    .x_label = "gamma",
                                    .y_label = "score",
                                    .series = {{"precision", {100, 200, 300}, {0.0, 0.5, 1.0}}},
                                    .categories = {}}});
  EXPECT_THAT(svg, HasSubstr("points=\"60.0,284.0 205.0,159.0 350.0,34.0 \""));
  EXPECT_THAT(svg, HasSubstr("P &amp; R &lt; 1"));
  EXPECT_THAT(svg, HasSubstr(">gamma</text>"));
  EXPECT_THAT(svg, HasSubstr(">precision</text>"));
  EXPECT_TRUE(svg.ends_with("</svg>"));
}

TEST(Plot, NamesFewValuesAndDividesTheRangeOfMany) {
  Series few{"few", {0, 3, 10}, {0, 0, 0}}, many{"many", {}, {}};
  for (int x = 0; x <= 20; ++x) {
    many.x.push_back(x);
    many.y.push_back(0);
  }
  const auto draw = [](const Series& series) {
    return DrawSvg(
        {{.title = "", .x_label = "", .y_label = "", .series = {series}, .categories = {}}});
  };
  EXPECT_THAT(draw(few), HasSubstr(">3</text>"));
  EXPECT_THAT(draw(many), HasSubstr(">15</text>"));
  EXPECT_THAT(draw(many), testing::Not(HasSubstr(">3</text>")));
}

TEST(Plot, DrawsABarPerSeriesAndCategory) {
  // Groups are 145 wide, of which two bars take 0.8.
  const std::string svg = DrawSvg({{.title = "methods",
                                    .x_label = "",
                                    .y_label = "F",
                                    .series = {{"box", {}, {0.5, 1}}, {"overlap", {}, {1, 0.2}}},
                                    .categories = {"a", "b"}}});
  EXPECT_THAT(svg, HasSubstr(R"(x="74.5" y="159.0" width="58.0" height="125.0")"));
  EXPECT_THAT(svg, HasSubstr(R"(x="277.5" y="234.0" width="58.0" height="50.0")"));
  EXPECT_THAT(svg, HasSubstr(">b</text>"));
}

}  // namespace
}  // namespace fovea::evaluation
