// Which positions are near which others, without a look at each pair.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "core/segmentation/cell_index.h"
#include "core/types/interruption.h"

namespace fovea {

// Space in cubes, numbered as they are met.
class Cubes {
 public:
  explicit Cubes(float side_m) : side_m_(side_m) {}

  int NumberOf(const Eigen::Vector3f& position) {
    const Eigen::Vector3i cube = (position / side_m_).array().floor().cast<int>();
    const int number = index_.FindOrAdd(cube, size());
    if (number == size()) cubes_.push_back(cube);
    return number;
  }

  // Sets `value` for the cube and the 26 around it, one entry a cube.
  void Mark(int number, char value, std::vector<char>& marks) const {
    for (int i = 0; i < 27; ++i) {
      const Eigen::Vector3i step(i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1);
      const int other = index_.Find(cubes_[number] + step);
      if (other >= 0) marks[other] = value;
    }
  }

  int size() const { return static_cast<int>(cubes_.size()); }

 private:
  const float side_m_;
  CellIndex index_;
  std::vector<Eigen::Vector3i> cubes_;
};

// Calls visit(members, near) for each cube that has any of `centers`, with sides of at least
// `reach_m`: the indices of those in it, and those of `others` in it or the 26 cubes around, among
// which are all within `reach_m` of a member. Both ascend. Cost: a look at each of
// `centers` and `others` a cube.
template <typename Visit>
void ForEachNeighborhood(const std::vector<Eigen::Vector3f>& centers,
                         const std::vector<Eigen::Vector3f>& others, float reach_m, Visit visit) {
  Cubes cubes(std::clamp(1.001F * reach_m, 1e-3F, 1e3F));  // a little more for rounding
  const auto cubes_of = [&](const std::vector<Eigen::Vector3f>& positions) {
    std::vector<int> numbers;
    numbers.reserve(positions.size());
    for (const Eigen::Vector3f& position : positions) numbers.push_back(cubes.NumberOf(position));
    return numbers;
  };
  InterruptionPoint();
  const std::vector<int> of_centers = cubes_of(centers);
  const int num_with_centers = cubes.size();
  InterruptionPoint();
  const std::vector<int> of_others = cubes_of(others);
  std::vector<char> is_near(cubes.size(), 0);
  std::vector<int> members, near;
  members.reserve(centers.size());
  near.reserve(others.size());
  for (int cube = 0; cube < num_with_centers; ++cube) {
    InterruptionPoint();
    members.clear();
    for (std::size_t i = 0; i < centers.size(); ++i) {
      if (of_centers[i] == cube) members.push_back(static_cast<int>(i));
    }
    cubes.Mark(cube, 1, is_near);
    near.clear();
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (is_near[of_others[i]] != 0) near.push_back(static_cast<int>(i));
    }
    cubes.Mark(cube, 0, is_near);
    visit(members, near);
  }
}

}  // namespace fovea
