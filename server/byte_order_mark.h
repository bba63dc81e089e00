#pragma once

#include <string_view>

namespace fovea::server {

// Some editors begin files with it; it belongs to no key and no name.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace fovea::server
