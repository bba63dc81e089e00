#include "core/scene/gravity.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr double kMinLevelShare = 0.07;  // of all normals
constexpr double kMinScoreShare = 0.72;

// A column a normal that there is.
struct Normals {
  Eigen::ArrayXd x, y, z;

  Eigen::Index Count() const { return x.size(); }
  auto Along(const Eigen::Vector3d& way) const { return way.x() * x + way.y() * y + way.z() * z; }
};

Normals ValidNormals(const cv::Mat& normals) {
  const auto most = static_cast<Eigen::Index>(normals.total());
  Normals valid{Eigen::ArrayXd(most), Eigen::ArrayXd(most), Eigen::ArrayXd(most)};
  Eigen::Index count = 0;
  for (int row = 0; row < normals.rows; ++row) {
    InterruptionPoint();
    const cv::Vec3f* normal = normals.ptr<cv::Vec3f>(row);
    for (int col = 0; col < normals.cols; ++col) {
      if (std::isnan(normal[col][0])) continue;
      valid.x[count] = normal[col][0];
      valid.y[count] = normal[col][1];
      valid.z[count++] = normal[col][2];
    }
  }
  for (Eigen::ArrayXd* axis : {&valid.x, &valid.y, &valid.z}) axis->conservativeResize(count);
  return valid;
}

// Remembers its answers: different starts soon meet.
class Refinement {
 public:
  explicit Refinement(const Normals& normals) : normals_(normals) { steps_.reserve(kUsualSteps); }

  Eigen::Vector3d Of(const Eigen::Vector3d& down, double angle_rad) {
    const auto known = std::find_if(steps_.begin(), steps_.end(), [&](const Step& step) {
      return step.from == down && step.angle_rad == angle_rad;
    });
    if (known != steps_.end()) return known->to;
    steps_.push_back({down, angle_rad, Refine(down, angle_rad)});
    return steps_.back().to;
  }

 private:
  static constexpr std::size_t kUsualSteps = 64;

  struct Step {
    Eigen::Vector3d from;
    double angle_rad;
    Eigen::Vector3d to;
  };

  Eigen::Vector3d Refine(const Eigen::Vector3d& down, double angle_rad) {
    const double level = std::cos(angle_rad), upright = std::sin(angle_rad);
    InterruptionPoint();
    // Floors want to be parallel, walls orthogonal.
    sign_ = normals_.Along(down).unaryExpr([=](double along) {
      const double c = std::abs(along);
      const double otherwise = c < upright ? 1 : 0;
      return c > level ? -1 : otherwise;
    });
    x_ = sign_ * normals_.x;
    y_ = sign_ * normals_.y;
    const double xx = (x_ * normals_.x).sum(), xy = (x_ * normals_.y).sum(),
                 xz = (x_ * normals_.z).sum(), yy = (y_ * normals_.y).sum(),
                 yz = (y_ * normals_.z).sum(), zz = (sign_ * normals_.z * normals_.z).sum();
    Eigen::Matrix3d scatter;
    scatter << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    if (scatter.isZero()) return down;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    const Eigen::Vector3d refined = solver.eigenvectors().col(0);  // eigenvalues ascend
    return refined.dot(down) < 0 ? -refined : refined;
  }

  const Normals& normals_;
  std::vector<Step> steps_;
  Eigen::ArrayXd sign_, x_, y_;  // kept for their memory
};

Eigen::Vector3d RefineFrom(Eigen::Vector3d down, Refinement& refinement,
                           const GravityOptions& options) {
  for (const double angle_deg : {options.coarse_angle_deg, options.fine_angle_deg}) {
    for (int i = 0; i < options.iterations; ++i) {
      const Eigen::Vector3d before =
          std::exchange(down, refinement.Of(down, angle_deg * std::numbers::pi / 180));
      if (down == before) break;  // and so would all further ones be
    }
  }
  return down;
}

// How many normals a direction explains.
struct Explained {
  double level = 0;    // of surfaces that face up
  double upright = 0;  // of walls; any direction in a wall explains it
  double Score() const { return level + 0.5 * upright; }
};

Explained Explain(const Normals& normals, const Eigen::Vector3d& down) {
  const double gate = 10 * std::numbers::pi / 180;
  const double level = std::cos(gate), upright = std::sin(gate);
  InterruptionPoint();
  const Eigen::ArrayXd along = normals.Along(down);
  return {static_cast<double>((along < -level).count()),
          static_cast<double>((along.abs() < upright).count())};
}

}  // namespace

Eigen::Vector3f EstimateGravity(const cv::Mat& normals, const GravityOptions& options) {
  const Normals valid = ValidNormals(normals);
  Refinement refinement(valid);
  std::vector<Eigen::Vector3d> directions;  // by rising pitch of the start
  std::vector<Explained> explained;
  directions.reserve(options.num_starts);
  explained.reserve(options.num_starts);
  double best_score = 0;
  for (int start = 0; start < options.num_starts; ++start) {
    const double pitch = start * std::numbers::pi / 2 / std::max(1, options.num_starts - 1);
    directions.push_back(RefineFrom({0, std::cos(pitch), std::sin(pitch)}, refinement, options));
    const auto known = std::find(directions.begin(), directions.end() - 1, directions.back());
    explained.push_back(known == directions.end() - 1 ? Explain(valid, directions.back())
                                                      : explained[known - directions.begin()]);
    best_score = std::max(best_score, explained.back().Score());
  }
  // A wall seen from the front looks like a floor seen from above. What tells them apart is that a
  // level surface is seen as well, so the least pitch that explains one and not much less than the
  // best is right.
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (explained[i].level < kMinLevelShare * static_cast<double>(valid.Count())) continue;
    if (explained[i].Score() >= kMinScoreShare * best_score) return directions[i].cast<float>();
  }
  const auto best = std::max_element(
      explained.begin(), explained.end(),
      [](const Explained& a, const Explained& b) { return a.Score() < b.Score(); });
  return directions[static_cast<std::size_t>(best - explained.begin())].cast<float>();
}

Gravity FindGravity(const std::optional<Eigen::Vector3f>& given, const cv::Mat& normals,
                    const GravityOptions& options) {
  if (given) return {given->normalized(), Gravity::Source::kGiven};
  const bool any = cv::countNonZero(normals.reshape(1) == normals.reshape(1)) > 0;  // but NaN
  return {EstimateGravity(normals, options),
          any ? Gravity::Source::kEstimated : Gravity::Source::kAssumed};
}

}  // namespace fovea
