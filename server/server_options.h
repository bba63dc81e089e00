#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fovea::server {

// The ranges of its whole numbers are in number_ranges.cc.
struct ServerOptions {
  // Each HOST:PORT, where port 0 takes a free one, or unix:/PATH. Other than loopback and UNIX
  // sockets only with TLS and either client certificates or tokens, or with `insecure`.
  std::vector<std::string> listen = {"127.0.0.1:50051"};
  // Serve callers from other machines unprotected.
  bool insecure = false;
  // PEM files: the server's certificate chain and its key; and the authority whose certificates
  // clients must have. Empty = no TLS; no client certificates.
  std::string tls_cert, tls_key, tls_client_ca;
  // PEM file of their lists of revoked certificates; empty = none are revoked.
  std::string tls_crl;
  // How often these files are read again, in seconds.
  int tls_reload_s = 30;
  // File of tokens, see TokenTable; empty = callers need none.
  std::string tokens;
  // File of those who may watch, see ObserverTable; empty = nobody may, and nothing is shown.
  std::string observers;
  // Streams that are open at once, of all robots and of one.
  int max_streams = 1000;
  int max_streams_per_robot = 16;
  // Of one host where nobody vouches for names; 0 = half of them. Never fewer than of
  // one robot.
  int max_streams_per_host = 0;
  // Connections that are open at once; fewer where the limit of open files asks for it, two of
  // which each takes. Of one host; 0 = half of them.
  int max_connections = 1024, max_connections_per_host = 0;
  // What of all messages that are not whole yet may have come, and of frames may wait in streams,
  // MiB each, and six messages of max_message_mib at least.
  int max_receiving_mib = 512;
  // What of all answers may wait for their callers to take them, MiB.
  int max_unsent_mib = 256;
  // How long a message may take to come, and an answer to be taken, in seconds.
  int max_transfer_s = 30;
  // How often the server asks itself for its health through its own door, in seconds; 0 = never,
  // unless systemd's watchdog asks. It ends when it does not answer itself three times in a row.
  int self_check_s = 10;
  // A connection without a call is closed after once to twice so many seconds: gRPC 1.51 does not
  // bound them, and a client that was destroyed while it connected keeps its connection.
  int max_idle_s = 300;
  // After so many seconds the caller of a connection is asked to open another one, and a stream is
  // ended after the answer it is at; 0 = never. So that what stands in front, or the client, can
  // choose another server.
  int max_connection_age_s = 0;
  // Largest request, MiB. The default lets 2048x1536 RGB8 with 32FC1 depth (21 MiB)
  // through.
  int max_message_mib = 24;
  // Largest decoded image in pixels.
  std::int64_t max_pixels = std::int64_t{2048} * 1536;
  // Frames that are computed at once; 0 = one per processor.
  int compute_threads = 0;
  // Of these, how many may work for one frame while the others have nothing to do; 0 =
  // all, 1 = each frame keeps to one thread.
  int threads_per_frame = 0;
  // How much these threads give way to the server's others, which refuse and receive, in steps
  // of niceness. More gives way to other programs of the machine as well.
  int compute_nice = 0;
  // What requests may change of the method: "none", "safe" (what is looked for and reported) or
  // "all"; and options, as NAME=VALUE, that hold for every frame whatever it asks for.
  std::string client_options = "all";
  std::vector<std::string> fixed_options;
  // Of robots whose requests name none, each ROBOT={…}; see RobotGrippers.
  std::vector<std::string> grippers;
  // Frames that wait beyond those; -1 = one per compute thread. More wait longer, fewer
  // are refused sooner. A stream's newest frame is not counted.
  int max_waiting = -1;
  // Frames that one robot may have waiting or computed; 0 = two thirds of all.
  int max_per_robot = 0;
  // Frames that one robot may have computed at once; 0 = as many as there are threads,
  // but one less while others call.
  int max_running_per_robot = 0;
  // Processor time that the detection of one frame may take, ms; 0 = any.
  int max_compute_ms = 5000;
  // How long to serve on with the health NOT_SERVING after a stop signal, in seconds: longer than
  // what stands in front (load balancer, probe) takes to notice. A second signal ends it.
  int hold_s = 0;
  // How long calls may go on after that, in seconds.
  int drain_timeout_s = 10;
  // HOST:PORT of Prometheus' metrics over HTTP; empty = none, port 0 takes a free one.
  std::string metrics_listen;
  // Collector of OpenTelemetry that takes spans as OTLP over HTTP, http://HOST[:PORT][/PATH]; empty
  // = none are made.
  std::string trace_endpoint;
  // Share of the frames that are traced of callers that send no traceparent, 0 … 1.
  double trace_share = 1;
  // Frames that take longer get a line in the log with the time of each stage; 0 = none
  // does. In ms.
  int slow_ms = 2000;
  // text or json.
  std::string log_format = "text";
  // trace, debug, info, warn, error or off.
  std::string log_level = "info";
};

// Throws std::invalid_argument that names flag, value and constraint.
void Validate(const ServerOptions& options);

// compute_threads, or one per processor where that is 0.
int NumComputeThreads(const ServerOptions& options);

// threads_per_frame, or all compute threads where that is 0.
int MaxThreadsPerFrame(const ServerOptions& options);

// "127.0.0.1" of "127.0.0.1:50051".
std::string HostOf(const std::string& listen);

// "/run/fovea.sock" of "unix:/run/fovea.sock".
bool IsUnixAddress(const std::string& listen);
std::string PathOfUnix(const std::string& listen);

}  // namespace fovea::server
