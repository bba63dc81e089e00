#pragma once

#include "server/server.h"
#include "server/settings.h"

namespace fovea::server {

// SIGHUP: reads the configuration, tokens and certificates again, takes over what can change while
// serving and names in the log the keys that need a restart. A mistake changes nothing, and the log
// says which. `in_force` is what the server runs with, as it was and as it is then.
void Reload(int argc, char** argv, Server& server, Settings* in_force);

}  // namespace fovea::server
