#include "core/shape/surface_samples.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace fovea {
namespace {

constexpr int kAcross = 8;   // samples along each side of a face
constexpr int kAround = 24;  // and around an axis
constexpr float kPi = std::numbers::pi_v<float>;

// A rectangle with these half sides.
void AddFace(const Eigen::Vector3f& center, const Eigen::Vector3f& u, const Eigen::Vector3f& v,
             const Eigen::Vector3f& normal, std::vector<SurfaceSample>& samples) {
  const float area = 4 * u.norm() * v.norm() / (kAcross * kAcross);
  for (int i = 0; i < kAcross; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const float a = (2 * static_cast<float>(i) + 1) / kAcross - 1;
      const float b = (2 * static_cast<float>(j) + 1) / kAcross - 1;
      samples.push_back({center + a * u + b * v, normal, area});
    }
  }
}

void AddBox(const Solid& solid, std::vector<SurfaceSample>& samples) {
  const Eigen::Vector3f u(solid.along.x(), solid.along.y(), 0),
      v(-solid.along.y(), solid.along.x(), 0);
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f middle(solid.center.x(), solid.center.y(), solid.height_m / 2);
  const Eigen::Vector3f a = solid.half_length_m * u, b = solid.half_width_m * v,
                        c = solid.height_m / 2 * up;
  AddFace(middle + c, a, b, up, samples);
  for (const float sign : {-1.0F, 1.0F}) {
    AddFace(middle + sign * a, b, c, sign * u, samples);
    AddFace(middle + sign * b, a, c, sign * v, samples);
  }
}

// A ring around an axis through `center`: `axis`, `u` and `v` are at right angles.
struct Axis {
  Eigen::Vector3f center, axis, u, v;
};

void AddRing(const Axis& axis, float along, float radius, float slope, float width,
             std::vector<SurfaceSample>& samples) {
  // Of a 24th of a turn, and of a half of that; multiplied, since sines differ between machines.
  constexpr float kCos = 0.965925826F, kSin = 0.258819045F;
  float c = 0.991444861F, s = 0.130526192F;
  const float area = 2 * kPi * radius * width / kAround;
  const float scale = 1 / std::sqrt(1 + slope * slope);
  for (int k = 0; k < kAround; ++k) {
    const Eigen::Vector3f out = c * axis.u + s * axis.v;
    const float turned = c * kCos - s * kSin;
    s = s * kCos + c * kSin;
    c = turned;
    samples.push_back(
        {axis.center + along * axis.axis + radius * out, (out - slope * axis.axis) * scale, area});
  }
}

// The wall from -half to half of the axis, then the discs that close it.
void AddRound(const Axis& axis, float half, const Solid& solid, bool close_first,
              std::vector<SurfaceSample>& samples) {
  constexpr float kStep = 0.5F / kAcross;  // from the middle of a ring to its ends
  for (int i = 0; i < kAcross; ++i) {
    const float share = (static_cast<float>(i) + 0.5F) / kAcross;
    const float slope =
        (solid.RadiusAt(share + kStep) - solid.RadiusAt(share - kStep)) / (4 * kStep * half);
    AddRing(axis, (2 * share - 1) * half, solid.RadiusAt(share), slope,
            2 * half / kAcross * std::sqrt(1 + slope * slope), samples);
  }
  constexpr int kRings = 3;
  for (const bool is_last : {false, true}) {
    if (!is_last && !close_first) continue;
    const float radius = solid.RadiusAt(is_last ? 1.0F : 0.0F), sign = is_last ? 1.0F : -1.0F;
    for (int i = 0; i < kRings; ++i) {
      const float r = radius * (static_cast<float>(i) + 0.5F) / kRings;
      const std::size_t begin = samples.size();
      AddRing(axis, sign * half, r, 0, radius / kRings, samples);
      for (std::size_t k = begin; k < samples.size(); ++k) samples[k].normal = sign * axis.axis;
    }
  }
}

void AddSphere(const Solid& solid, std::vector<SurfaceSample>& samples) {
  const Eigen::Vector3f center(solid.center.x(), solid.center.y(), solid.radius_m);
  const Axis axis{center, Eigen::Vector3f::UnitZ(), Eigen::Vector3f::UnitX(),
                  Eigen::Vector3f::UnitY()};
  for (int i = 0; i < kAcross; ++i) {  // layers of the same height have the same area
    const float h = (2 * static_cast<float>(i) + 1) / kAcross - 1;
    const std::size_t begin = samples.size();
    AddRing(axis, h * solid.radius_m, solid.radius_m * std::sqrt(1 - h * h), 0, 0, samples);
    for (std::size_t k = begin; k < samples.size(); ++k) {
      samples[k].normal = (samples[k].position - center) / solid.radius_m;
      samples[k].area_m2 = 4 * kPi * solid.radius_m * solid.radius_m / (kAcross * kAround);
    }
  }
}

// The discs at both ends of the straight part, walls as well, and what is between them.
void AddOblong(const Solid& solid, std::vector<SurfaceSample>& samples) {
  const Eigen::Vector3f u(solid.along.x(), solid.along.y(), 0),
      v(-solid.along.y(), solid.along.x(), 0);
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f middle(solid.center.x(), solid.center.y(), solid.height_m / 2);
  const float straight = solid.half_length_m - solid.half_width_m;
  Solid end = solid;
  end.kind = Solid::Kind::kUprightCylinder;
  end.radius_m = solid.half_width_m;
  std::vector<SurfaceSample> round;
  AddRound({middle, up, u, v}, solid.height_m / 2, end, false, round);
  for (SurfaceSample& sample : round) {
    const float side = (sample.position - middle).dot(u) > 0 ? 1.0F : -1.0F;
    sample.position += side * straight * u;
    samples.push_back(sample);
  }
  const Eigen::Vector3f a = straight * u, b = solid.half_width_m * v, c = solid.height_m / 2 * up;
  AddFace(middle + c, a, b, up, samples);
  for (const float sign : {-1.0F, 1.0F}) AddFace(middle + sign * b, a, c, sign * v, samples);
}

// Rings around its axis; the halves of a ball at both ends.
void AddBent(const Solid& solid, std::vector<SurfaceSample>& samples) {
  const Eigen::Vector3f along(solid.along.x(), solid.along.y(), 0),
      left(-solid.along.y(), solid.along.x(), 0);
  const Eigen::Vector3f middle(solid.center.x(), solid.center.y(), solid.radius_m);
  const float reach = solid.half_length_m - solid.radius_m;
  const auto add_ring = [&](float share, float from_end, float radius, float slope, float width) {
    const float bend = solid.bend_m * (share * share - 0.5F),
                turn = 2 * solid.bend_m * share / reach;
    const Eigen::Vector3f axis = (along + turn * left).normalized();
    const Eigen::Vector3f center = middle + share * reach * along + bend * left;
    const Eigen::Vector3f side = Eigen::Vector3f::UnitZ().cross(axis);
    AddRing({center, axis, side, Eigen::Vector3f::UnitZ()}, from_end, radius, slope, width,
            samples);
  };
  for (int i = 0; i < kAcross; ++i) {
    const float share = (2 * static_cast<float>(i) + 1) / kAcross - 1;
    const float slope = 2 * solid.bend_m * share / reach;
    add_ring(share, 0, solid.radius_m, 0, 2 * reach / kAcross * std::sqrt(1 + slope * slope));
  }
  constexpr int kLayers = 3;  // of the same height: of the same area
  for (const float end : {-1.0F, 1.0F}) {
    for (int i = 0; i < kLayers; ++i) {
      const float h = (static_cast<float>(i) + 0.5F) / kLayers, r = std::sqrt(1 - h * h);
      add_ring(end, end * h * solid.radius_m, r * solid.radius_m, -end * h / r,
               solid.radius_m / (kLayers * r));
    }
  }
}

}  // namespace

std::vector<SurfaceSample> SampleSurface(const Solid& solid) {
  constexpr std::size_t kMost = kAround * (kAcross + 6) + 3 * kAcross * kAcross;
  std::vector<SurfaceSample> samples;
  samples.reserve(kMost);
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f u(solid.along.x(), solid.along.y(), 0),
      v(-solid.along.y(), solid.along.x(), 0);
  const Eigen::Vector3f ground(solid.center.x(), solid.center.y(), 0);
  switch (solid.kind) {
    case Solid::Kind::kBox:
      AddBox(solid, samples);
      break;
    case Solid::Kind::kUprightCylinder:
    case Solid::Kind::kFrustum: {
      const Axis axis{ground + up * (solid.height_m / 2), up, u, v};
      AddRound(axis, solid.height_m / 2, solid, false, samples);
      break;
    }
    case Solid::Kind::kLyingCylinder:
      AddRound({ground + up * solid.radius_m, u, v, up}, solid.half_length_m, solid, true, samples);
      break;
    case Solid::Kind::kSphere:
      AddSphere(solid, samples);
      break;
    case Solid::Kind::kOblong:
      AddOblong(solid, samples);
      break;
    case Solid::Kind::kBent:
      AddBent(solid, samples);
      break;
  }
  return samples;
}

}  // namespace fovea
