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
  const DetectorOptions options = OptionsOfProfile("paper");
  ASSERT_TRUE(options.paper.has_value());
  const paper::PaperOptions& paper = *options.paper;
  EXPECT_EQ(paper.mrf.data.gamma_per_m2, 180);
  EXPECT_EQ(paper.mrf.data.alpha, 0.1);
  EXPECT_EQ(paper.color_merge.min_correlation, 0.5);
  EXPECT_EQ(paper.color_merge.bins, 20);
  EXPECT_EQ(paper.color_saliency.num_scales, 4);
  EXPECT_EQ(paper.seeds.disk_radius_px, 10);  // 20 pixels across
}

TEST(Options, UnknownProfilesAreNamed) {
  EXPECT_THAT([] { OptionsOfProfile("fast"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("\"fast\"")));
}

TEST(Options, EachNameIsReadBySomeProfileAndSetsItsOwnValue) {
  std::set<std::string> read;
  for (const std::string& profile : ProfileNames()) {
    const auto defaults = OptionValues(OptionsOfProfile(profile));
    for (const OptionInfo& info : ListOptions()) {
      EXPECT_FALSE(info.description.empty()) << info.name;
      if (!defaults.contains(info.name)) continue;
      read.insert(info.name);
      DetectorOptions options = OptionsOfProfile(profile);
      const double other = defaults.at(info.name) == info.minimum ? info.maximum : info.minimum;
      SetOption(options, info.name, other);
      for (const auto& [name, value] : OptionValues(options)) {
        EXPECT_EQ(value, name == info.name ? other : defaults.at(name)) << info.name << " " << name;
      }
    }
  }
  EXPECT_EQ(read.size(), ListOptions().size());
}

TEST(Options, WhatAProfileDoesNotReadCannotBeSetThere) {
  DetectorOptions paper = OptionsOfProfile("paper");
  EXPECT_FALSE(HasOption(paper, "mrf.concave_angle_deg"));
  EXPECT_THAT([&] { SetOption(paper, "mrf.concave_angle_deg", 12); },
              ThrowsMessage<std::invalid_argument>(
                  testing::AllOf(HasSubstr("mrf.concave_angle_deg"), HasSubstr("\"paper\""))));
  DetectorOptions options = OptionsOfProfile("default");
  EXPECT_TRUE(IsOption("mrf.epsilon"));
  EXPECT_THAT([&] { SetOption(options, "mrf.epsilon", 0.1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("\"default\"")));
}

// Each must be understood by those who set it, and tried by those who change the method.
TEST(Options, TheDefaultProfileHasFew) {
  EXPECT_LE(OptionValues(OptionsOfProfile("default")).size(), 40U);
}

TEST(Options, ValuesOutOfRangeAreNamedWithTheirRange) {
  DetectorOptions options;
  EXPECT_THAT([&] { SetOption(options, "mrf.alpha", 2); },
              ThrowsMessage<std::invalid_argument>(
                  testing::AllOf(HasSubstr("mrf.alpha"), HasSubstr("2"), HasSubstr("to 1"))));
  EXPECT_THROW(SetOption(options, "mrf.alpha", std::numeric_limits<double>::quiet_NaN()),
               std::invalid_argument);
  EXPECT_THAT([&] { SetOption(options, "mrf.cluster_voxels", 1.5); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("whole number")));
  EXPECT_THAT([&] { SetOption(options, "mrf.beta", 1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("mrf.beta")));
  options.voxels.size_m = 0;
  EXPECT_THAT([&] { Validate(options); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("voxels.size_m")));
}

}  // namespace
}  // namespace fovea
