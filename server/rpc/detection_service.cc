#include "server/rpc/detection_service.h"

#include <utility>

#include "server/watching/statistics.h"

namespace fovea::server {

DetectionService::DetectionService(v1::GetServerInfoResponse info, const Metrics& metrics)
    : info_(std::move(info)), metrics_(metrics) {}

grpc::Status DetectionService::GetServerInfo(grpc::ServerContext* /*context*/,
                                             const v1::GetServerInfoRequest* /*request*/,
                                             v1::GetServerInfoResponse* response) {
  *response = info_;
  return grpc::Status::OK;
}

grpc::Status DetectionService::GetStatistics(grpc::ServerContext* /*context*/,
                                             const v1::GetStatisticsRequest* /*request*/,
                                             v1::GetStatisticsResponse* response) {
  *response = StatisticsOf(metrics_.Collect(), std::chrono::steady_clock::now() - started_);
  return grpc::Status::OK;
}

}  // namespace fovea::server
