// Which step in depth is more than noise.
#pragma once

namespace fovea {

// Depths closer than this are one surface; grows like the noise of structured light and stereo
// cameras. Metres.
inline float DepthGap_m(float z_m) { return 0.015F + 0.012F * z_m * z_m; }

}  // namespace fovea
