// The limits of the server's parts, by what its operator has set and by this machine.
#pragma once

#include <cstddef>

#include "server/access/stream_places.h"
#include "server/connections/connection_table.h"
#include "server/scheduling/scheduler.h"
#include "server/server_options.h"

namespace fovea::server {

SchedulerLimits SchedulerLimitsOf(const ServerOptions& options);

// Warns in the log where fewer files may be open than the connections that were set need.
ConnectionLimits ConnectionLimitsOf(const ServerOptions& options);

// The memory that gRPC may take. Beyond it gRPC gives up calls, whosever they are: so it is more
// than what the server's own limits let come in part, wait in streams and wait in calls, and what
// comes until they are looked at.
std::size_t GrpcQuotaOf(const ServerOptions& options);

StreamLimits StreamLimitsOf(const ServerOptions& options);

}  // namespace fovea::server
