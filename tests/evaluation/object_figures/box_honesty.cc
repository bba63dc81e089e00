#include "tests/evaluation/object_figures/box_honesty.h"

#include <cmath>
#include <numbers>

#include "tests/evaluation/generated/true_class.h"
#include "tests/evaluation/object_figures/box_errors.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {

bool ErrorAndSigma::IsWithin(double sigmas) const { return std::abs(error) <= sigmas * sigma; }

UncertainBox CompareUncertainBox(const scenes::Body& body, const DetectedObject& answer,
                                 const Eigen::Isometry3d& world_from_camera) {
  UncertainBox compared;
  if (!answer.uncertainty) return compared;
  const OrientedBox box = InWorld(answer.box, world_from_camera);
  const OrientedBox truth =
      IsRoundUpright(body) ? TrueBoxAlong(body, box.rotation.col(0)) : TrueBox(body);
  const Eigen::Vector3f middle = box.rotation.transpose() * (box.center - truth.center);
  const Eigen::Matrix4f& covariance = answer.uncertainty->pose_covariance;
  const Eigen::Matrix3f of_middle =
      answer.box.rotation.transpose() * covariance.topLeftCorner<3, 3>() * answer.box.rotation;
  const BoxErrors errors = CompareBoxes(body, box);
  for (int i = 0; i < 3; ++i) {
    const auto index = static_cast<std::size_t>(i);
    compared[index] = {errors.size_m[i], answer.uncertainty->size_sigma_m[i]};
    compared[3 + index] = {middle[i], std::sqrt(of_middle(i, i))};
  }
  if (errors.yaw_deg && !answer.yaw_is_arbitrary) {
    compared[6] = {*errors.yaw_deg * std::numbers::pi / 180, std::sqrt(covariance(3, 3))};
  }
  return compared;
}

std::vector<Honesty> HonestyOf(const std::vector<UncertainBox>& boxes) {
  std::vector<Honesty> all;
  for (std::size_t i = 0; i < kUncertainNumbers.size(); ++i) {
    std::vector<double> errors, sigmas;
    Honesty honesty;
    honesty.name = kUncertainNumbers[i];
    for (const UncertainBox& box : boxes) {
      if (!box[i]) continue;
      errors.push_back(std::abs(box[i]->error));
      sigmas.push_back(box[i]->sigma);
      honesty.within_one += box[i]->IsWithin(1);
      honesty.within_two += box[i]->IsWithin(2);
    }
    if (errors.empty()) continue;
    honesty.count = errors.size();
    honesty.within_one /= static_cast<double>(errors.size());
    honesty.within_two /= static_cast<double>(errors.size());
    honesty.median_error = Median(errors);
    honesty.median_sigma = Median(sigmas);
    all.push_back(honesty);
  }
  return all;
}

}  // namespace fovea::evaluation
