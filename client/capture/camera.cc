#include "client/capture/camera.h"

#include "client/capture/openni_camera.h"
#include "client/capture/v4l2_camera.h"

namespace fovea::capture {

std::unique_ptr<Camera> OpenCamera(const CameraOptions& options, std::ostream& notes) {
  if (IsV4l2(options.device)) return std::make_unique<V4l2Camera>(options);
  return std::make_unique<OpenNiCamera>(options, notes);
}

}  // namespace fovea::capture
