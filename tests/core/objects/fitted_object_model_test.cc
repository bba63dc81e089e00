// What the fitted model has learned: which way each kind of evidence points.
#include <gtest/gtest.h>

#include <cmath>

#include "core/objects/object_model.h"

namespace fovea {
namespace {

const TermFunction& FunctionOf(ObjectTerm term) {
  return FittedObjectModel().functions[static_cast<std::size_t>(term)];
}

// How much the log weight changes from one value of a term to another.
double Change(ObjectTerm term, double from, double to) {
  return FunctionOf(term).Of(to) - FunctionOf(term).Of(from);
}

TEST(TermFunction, ChangesItsSlopeAtKnots) {
  TermFunction function;
  function.slopes = {1, 2, 0, 0, 0, 0};
  function.knots[0] = 3;
  EXPECT_DOUBLE_EQ(function.Of(2), 2);
  EXPECT_DOUBLE_EQ(function.Of(3), 3);
  EXPECT_DOUBLE_EQ(function.Of(5), 9);
}

TEST(FittedObjectModel, ObjectsAreNeitherTinyNorHuge) {
  EXPECT_GT(Change(ObjectTerm::kArea, std::log(0.0003), std::log(0.005)), 2);
  EXPECT_LT(Change(ObjectTerm::kLargestExtent, std::log(0.2), std::log(1)), -1);
}

TEST(FittedObjectModel, WhatGoesOnIsNoObject) {
  EXPECT_LT(Change(ObjectTerm::kClosed, 0, 0.9), -1);
  EXPECT_LT(Change(ObjectTerm::kEndsAnywhere, 0, 1), -0.5);
  EXPECT_LT(Change(ObjectTerm::kLevelSegment, 0, 0.7), -1);
}

TEST(FittedObjectModel, WhatIsNoHigherThanItsSupportIsPartOfIt) {
  EXPECT_LT(Change(ObjectTerm::kFlat, 0, 1), -0.5);
}

TEST(FittedObjectModel, WhatTheJoinsFavourIsLikelier) {
  EXPECT_LT(Change(ObjectTerm::kOuterOdds, -3, 3), -2);
}

TEST(FittedObjectModel, ContrastToTheBackgroundSpeaksForAnObject) {
  EXPECT_GT(Change(ObjectTerm::kContrast, std::log(4), std::log(40)), 0.3);
}

}  // namespace
}  // namespace fovea
