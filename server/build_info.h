// Which server this is: the same for all answers of one executable.
#pragma once

namespace fovea::server {

// For example "0.1.0".
const char* Version();

// The commit that it was built from, in 12 digits; "-modified" follows where files differed from
// it. "unknown" where the sources were in no repository and the build was not told
// (-DFOVEA_COMMIT=…).
const char* Commit();

}  // namespace fovea::server
