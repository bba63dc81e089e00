// The linear assignment problem: which of one kind goes with which of the other.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace fovea {

// Pairs rows with columns so that the sum of the gains of the pairs is as large as possible
// (Hungarian method, O(rows² · columns)). Every row gets a column of its own as long as there are
// any. Gains are finite. Returns the column of each row, -1 for a row without one.
std::vector<int> MaximumAssignment(const Eigen::MatrixXd& gains);

}  // namespace fovea
