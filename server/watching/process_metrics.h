// Memory, descriptors and processor time of this process, under the names that Prometheus'
// libraries have for them.
#pragma once

#include <dirent.h>
#include <prometheus/collectable.h>

#include <memory>
#include <vector>

namespace fovea::server {

// Holds what it reads from open, since it must tell most when there are no descriptors left.
// Collect() may be called from one thread at a time.
class ProcessMetrics : public prometheus::Collectable {
 public:
  ProcessMetrics();
  ~ProcessMetrics() override;

  ProcessMetrics(const ProcessMetrics&) = delete;
  ProcessMetrics& operator=(const ProcessMetrics&) = delete;

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  double ResidentBytes() const;
  double NumOpenFiles() const;

  DIR* const files_;
  const int memory_;
  const double started_s_;  // since 1970
};

}  // namespace fovea::server
