// Intrinsics of the cameras of a request.
#pragma once

#include <optional>
#include <string>

#include "core/lens/lens.h"
#include "core/types/rgbd_frame.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// Throws std::invalid_argument that starts with the field, for example "<path>.fx: …", unless
// focal lengths are finite and positive and the principal point is finite.
CameraIntrinsics FromProto(const v1::CameraIntrinsics& intrinsics, const std::string& path);

// The lens of a camera with this image, whose intrinsics were checked; none without distortion.
// Throws std::invalid_argument that starts with the field, for example
// "<path>.distortion.coefficients: …".
std::optional<Lens> LensFromProto(const v1::CameraIntrinsics& intrinsics, const cv::Size& size,
                                  const std::string& path);

// Throws std::invalid_argument that starts with the field unless a camera can have these intrinsics
// with an image of this size, see the core's function of this name.
void RequirePlausible(const CameraIntrinsics& intrinsics, const cv::Size& size,
                      const std::string& path);

}  // namespace fovea::server
