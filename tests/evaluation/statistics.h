// Small sums over lists of numbers.
#pragma once

#include <vector>

namespace fovea::evaluation {

// The value below which this share of them lies, at most the largest; 0 of none.
double Quantile(std::vector<double> values, double share);

// The upper one of the two in the middle of an even number; 0 of none.
double Median(std::vector<double> values);

struct Spread {
  double mean = 0;
  double deviation = 0;  // standard deviation of the sample (N − 1); 0 below two values
};

Spread SpreadOf(const std::vector<double>& values);

// What the straight line through the points (least squares) says of `x`; their mean if all `xs` are
// the same, 0 of none. `xs` and `ys`: as many.
double LineAt(double x, const std::vector<double>& xs, const std::vector<double>& ys);

}  // namespace fovea::evaluation
