#include "server/watching/process_metrics.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "server/watching/metric_kinds.h"

namespace fovea::server {
namespace {

using prometheus::MetricType;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

double ProcessorSeconds() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return kUnknown;
  return Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
}

double MaxFiles() {
  rlimit limit{};
  return getrlimit(RLIMIT_NOFILE, &limit) == 0 ? static_cast<double>(limit.rlim_cur) : kUnknown;
}

// Of the machine, in seconds since 1970.
double BootTime() {
  std::ifstream file("/proc/stat");
  for (std::string word; file >> word;) {
    double time = 0;
    if (word == "btime" && file >> time) return time;
  }
  return kUnknown;
}

double StartTime() {
  constexpr int kFieldsBefore = 19;  // between the program's name, which may hold anything, and it
  std::ifstream file("/proc/self/stat");
  std::string text;
  std::getline(file, text);
  std::istringstream fields(text.substr(text.rfind(')') + 1));
  std::string skipped;
  for (int i = 0; i < kFieldsBefore; ++i) fields >> skipped;
  double ticks = 0;
  if (!(fields >> ticks)) return kUnknown;
  return BootTime() + ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

ProcessMetrics::ProcessMetrics()
    : files_(opendir("/proc/self/fd")),
      memory_(open("/proc/self/statm", O_RDONLY | O_CLOEXEC)),
      started_s_(StartTime()) {}

ProcessMetrics::~ProcessMetrics() {
  if (files_ != nullptr) closedir(files_);
  if (memory_ >= 0) close(memory_);
}

std::vector<prometheus::MetricFamily> ProcessMetrics::Collect() const {
  return {
      SingleMetric("process_resident_memory_bytes", "Memory of this process that is in RAM",
                   MetricType::Gauge, ResidentBytes()),
      SingleMetric("process_open_fds", "Descriptors that are open", MetricType::Gauge,
                   NumOpenFiles()),
      SingleMetric("process_max_fds", "Descriptors that may be open", MetricType::Gauge,
                   MaxFiles()),
      SingleMetric("process_cpu_seconds_total", "Processor time spent, user and system",
                   MetricType::Counter, ProcessorSeconds()),
      SingleMetric("process_start_time_seconds", "When the process started, since 1970",
                   MetricType::Gauge, started_s_),
  };
}

double ProcessMetrics::ResidentBytes() const {
  std::array<char, 128> text{};
  if (pread(memory_, text.data(), text.size() - 1, 0) <= 0) return kUnknown;
  std::istringstream numbers(text.data());
  double total = 0, resident = 0;  // in pages
  if (!(numbers >> total >> resident)) return kUnknown;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double ProcessMetrics::NumOpenFiles() const {
  if (files_ == nullptr) return kUnknown;
  rewinddir(files_);
  double count = 0;
  while (const dirent* entry = readdir(files_)) {
    if (entry->d_name[0] != '.') ++count;
  }
  return count;
}

}  // namespace fovea::server
