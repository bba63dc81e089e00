#include "client/capture/camera.h"

#include <stdexcept>

#include "client/capture/openni_camera.h"
#include "client/capture/v4l2_camera.h"

namespace fovea::capture {

std::unique_ptr<Camera> OpenCamera(const CameraOptions& options, std::ostream& notes) {
  switch (KindOf(options.device)) {
    case CameraKind::kOpenNi:
      return std::make_unique<OpenNiCamera>(options, notes);
    case CameraKind::kV4l2:
      return std::make_unique<V4l2Camera>(options);
  }
  throw std::logic_error("a camera of no kind");
}

}  // namespace fovea::capture
