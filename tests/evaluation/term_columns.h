// Functions of one term as columns of a fit.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/types/term_function.h"

namespace fovea::evaluation {

inline constexpr int kColumnsOfTerm = static_cast<int>(TermFunction::kNumKnots) + 1;

// Of slope 0, with knots at quantiles of the values; none where they are two or fewer numbers.
TermFunction WithKnotsAt(std::vector<double> values);

// What the slopes are multiplied by.
Eigen::Matrix<double, 1, kColumnsOfTerm> ColumnsOf(const TermFunction& knots, double term);

// As source, where `kNone` stands for no knot.
std::string SourceOf(const TermFunction& function);

}  // namespace fovea::evaluation
