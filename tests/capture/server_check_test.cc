#include "client/capture/server_check.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fovea::capture {
namespace {

TEST(CheckVersions, TakesWhatIsCompatible) {
  EXPECT_NO_THROW(CheckVersions("0.1.0", "0.1.7"));
  EXPECT_NO_THROW(CheckVersions("1.2.0", "1.9.3"));
}

TEST(CheckVersions, RefusesTheRest) {
  EXPECT_THROW(CheckVersions("0.1.0", "0.2.0"), std::runtime_error);
  EXPECT_THROW(CheckVersions("1.1.0", "2.1.0"), std::runtime_error);
  EXPECT_THROW(CheckVersions("0.1.0", "1.1.0"), std::runtime_error);
  EXPECT_THROW(CheckVersions("0.1.0", ""), std::runtime_error);
}

}  // namespace
}  // namespace fovea::capture
