// Which threads give way to others.
#pragma once

namespace fovea::server {

// The calling thread shall give way to others: `steps` more of niceness than the process has, up
// to what the system allows.
void LowerPriority(int steps);

}  // namespace fovea::server
