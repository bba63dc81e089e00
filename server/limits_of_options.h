// The limits of the server's parts, by what its operator has set and by this machine.
#pragma once

#include "server/access/stream_places.h"
#include "server/connections/connection_table.h"
#include "server/scheduling/scheduler.h"
#include "server/server_options.h"

namespace fovea::server {

SchedulerLimits SchedulerLimitsOf(const ServerOptions& options);

// Warns in the log where fewer files may be open than the connections that were set need.
ConnectionLimits ConnectionLimitsOf(const ServerOptions& options);

StreamLimits StreamLimitsOf(const ServerOptions& options);

}  // namespace fovea::server
