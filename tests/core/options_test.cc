#include "core/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>

namespace fovea {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Options, EveryProfileIsValid) {
  for (const std::string& name : ProfileNames()) EXPECT_NO_THROW(Validate(OptionsOfProfile(name)));
}

TEST(Options, TheEmptyProfileIsTheDefaultOne) {
  EXPECT_EQ(OptionValues(OptionsOfProfile("")), OptionValues(OptionsOfProfile("default")));
}

TEST(Options, PaperHasThePapersValues) {
  const DetectorOptions paper = OptionsOfProfile("paper");
  EXPECT_EQ(paper.mrf.gamma_per_m2, 180);
  EXPECT_EQ(paper.mrf.alpha, 0.1);
  EXPECT_EQ(paper.color_merge.min_correlation, 0.5);
  EXPECT_EQ(paper.color_merge.bins, 20);
  EXPECT_EQ(paper.color_saliency.num_scales, 4);
}

TEST(Options, UnknownProfilesAreNamed) {
  EXPECT_THAT([] { OptionsOfProfile("fast"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("\"fast\"")));
}

TEST(Options, EachNameIsThereOnceAndSetsItsOwnValue) {
  const auto defaults = OptionValues(DetectorOptions{});
  EXPECT_EQ(defaults.size(), ListOptions().size());
  for (const OptionInfo& info : ListOptions()) {
    EXPECT_FALSE(info.description.empty()) << info.name;
    DetectorOptions options;
    const double other = defaults.at(info.name) == info.minimum ? info.maximum : info.minimum;
    SetOption(options, info.name, other);
    const auto values = OptionValues(options);
    for (const auto& [name, value] : values) {
      EXPECT_EQ(value, name == info.name ? other : defaults.at(name)) << info.name << " " << name;
    }
  }
}

TEST(Options, ValuesOutOfRangeAreNamedWithTheirRange) {
  DetectorOptions options;
  EXPECT_THAT([&] { SetOption(options, "mrf.alpha", 2); },
              ThrowsMessage<std::invalid_argument>(
                  testing::AllOf(HasSubstr("mrf.alpha"), HasSubstr("2"), HasSubstr("to 1"))));
  EXPECT_THROW(SetOption(options, "mrf.alpha", std::numeric_limits<double>::quiet_NaN()),
               std::invalid_argument);
  EXPECT_THAT([&] { SetOption(options, "voxels.neighbor_axes", 1.5); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("whole number")));
  EXPECT_THAT([&] { SetOption(options, "mrf.beta", 1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("mrf.beta")));
  options.voxels.size_m = 0;
  EXPECT_THAT([&] { Validate(options); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("voxels.size_m")));
}

}  // namespace
}  // namespace fovea
