#include "tests/evaluation/settings.h"

#include <gmock/gmock.h>

namespace fovea::evaluation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::ThrowsMessage;

TEST(Settings, AreNamesWithNumbers) {
  EXPECT_THAT(ParseSetting("mrf.lambda=5,0.5"), Pair("mrf.lambda", ElementsAre(5, 0.5)));
  for (const char* text : {"mrf.lambda=", "mrf.lambda=abc", "mrf.lambda=5x", "mrf.lambda=5,nan"}) {
    EXPECT_THAT([&] { ParseSetting(text); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("is no number")))
        << text;
  }
}

TEST(Settings, SetOneValueEach) {
  DetectorOptions options = OptionsOfProfile("default");
  ApplySettings(options, {"mrf.lambda=5"});
  EXPECT_EQ(OptionValues(options).at("mrf.lambda"), 5);
  EXPECT_THAT([&] { ApplySettings(options, {"mrf.lambda=5,6"}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("expected one value")));
}

TEST(Settings, OfASweepAreAllInRange) {
  const DetectorOptions options = OptionsOfProfile("default");
  EXPECT_THAT(ParseSweep("mrf.lambda=5,6", options), Pair("mrf.lambda", ElementsAre(5, 6)));
  EXPECT_THAT([&] { ParseSweep("mrf.lambda=5,5000", options); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("not in the range")));
}

TEST(Settings, WeighFolders) {
  EXPECT_THAT(ParseWeighted("osd"), Pair("osd", 1));
  EXPECT_THAT(ParseWeighted("osd=2.5"), Pair("osd", 2.5));
  for (const char* text : {"osd=", "osd=x", "osd=nan", "osd=-1", "osd=0"}) {
    EXPECT_THROW(ParseWeighted(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace fovea::evaluation
