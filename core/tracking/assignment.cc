#include "core/tracking/assignment.h"

#include <limits>

namespace fovea {
namespace {

// The state of the method on a cost matrix with rows <= columns. Index 0 of each vector is a
// virtual row or column, from which a new row enters.
struct Hungarian {
  const Eigen::MatrixXd& cost;
  std::vector<double> row_potential = std::vector<double>(cost.rows() + 1, 0.0);
  std::vector<double> column_potential = std::vector<double>(cost.cols() + 1, 0.0);
  std::vector<int> row_of_column = std::vector<int>(cost.cols() + 1, 0);

  // Finds the cheapest alternating path from `row` to a free column and turns it over.
  void Enter(int row) {
    const int columns = static_cast<int>(cost.cols());
    std::vector<double> slack(columns + 1, std::numeric_limits<double>::infinity());
    std::vector<int> previous(columns + 1, 0);
    std::vector<bool> used(columns + 1, false);
    row_of_column[0] = row;
    int column = 0;
    do {
      used[column] = true;
      const int i = row_of_column[column];
      int next = 0;
      double delta = std::numeric_limits<double>::infinity();
      for (int j = 1; j <= columns; ++j) {
        if (used[j]) continue;
        const double reduced = cost(i - 1, j - 1) - row_potential[i] - column_potential[j];
        if (reduced < slack[j]) {
          slack[j] = reduced;
          previous[j] = column;
        }
        if (slack[j] < delta) {
          delta = slack[j];
          next = j;
        }
      }
      for (int j = 0; j <= columns; ++j) {
        if (used[j]) {
          row_potential[row_of_column[j]] += delta;
          column_potential[j] -= delta;
        } else {
          slack[j] -= delta;
        }
      }
      column = next;
    } while (row_of_column[column] != 0);
    for (; column != 0; column = previous[column]) {
      row_of_column[column] = row_of_column[previous[column]];
    }
  }
};

}  // namespace

std::vector<int> MaximumAssignment(const Eigen::MatrixXd& gains) {
  const bool transposed = gains.rows() > gains.cols();
  Eigen::MatrixXd cost = -gains;
  if (transposed) cost.transposeInPlace();
  Hungarian hungarian{cost};
  for (int row = 1; row <= cost.rows(); ++row) hungarian.Enter(row);

  std::vector<int> column_of_row(gains.rows(), -1);
  for (int column = 1; column <= cost.cols(); ++column) {
    const int row = hungarian.row_of_column[column];
    if (row == 0) continue;
    if (transposed) {
      column_of_row[column - 1] = row - 1;
    } else {
      column_of_row[row - 1] = column - 1;
    }
  }
  return column_of_row;
}

}  // namespace fovea
