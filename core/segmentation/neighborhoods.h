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
// which are all within `reach_m` of a member. Both ascend. Cost: a look at each of `others` a cube.
template <typename Visit>
void ForEachNeighborhood(const std::vector<Eigen::Vector3f>& centers,
                         const std::vector<Eigen::Vector3f>& others, float reach_m, Visit visit) {
  Cubes cubes(std::clamp(1.001F * reach_m, 1e-3F, 1e3F));  // a little more for rounding
  std::vector<std::vector<int>> members;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const int cube = cubes.NumberOf(centers[i]);
    members.resize(cubes.size());
    members[cube].push_back(static_cast<int>(i));
  }
  InterruptionPoint();
  std::vector<int> cube_of_other;
  cube_of_other.reserve(others.size());
  for (const Eigen::Vector3f& other : others) cube_of_other.push_back(cubes.NumberOf(other));
  std::vector<char> is_near(cubes.size(), 0);
  std::vector<int> near;
  for (std::size_t cube = 0; cube < members.size(); ++cube) {
    InterruptionPoint();
    cubes.Mark(static_cast<int>(cube), 1, is_near);
    near.clear();
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (is_near[cube_of_other[i]] != 0) near.push_back(static_cast<int>(i));
    }
    cubes.Mark(static_cast<int>(cube), 0, is_near);
    visit(members[cube], near);
  }
}

}  // namespace fovea
