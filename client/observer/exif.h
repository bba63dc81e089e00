// Pictures for browsers.
#pragma once

#include <string>

namespace fovea::observer {

// The JPEG file with the names of its Exif segments spoilt: browsers turn a picture by what they
// say, while masks and boxes are those of pixels as they are stored. Other bytes as they are.
std::string WithoutExif(std::string jpeg);

}  // namespace fovea::observer
