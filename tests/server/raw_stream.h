#pragma once

#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::testing {

// One call of DetectStream that sends bytes as they are, one message at a time.
class RawStream {
 public:
  explicit RawStream(const std::string& address)
      : stub_(grpc::CreateChannel(address, grpc::InsecureChannelCredentials())),
        call_(stub_.PrepareCall(&context_, "/fovea.v1.DetectionService/DetectStream", &queue_)) {
    call_->StartCall(nullptr);
    Wait();
  }
  ~RawStream() {
    context_.TryCancel();
    grpc::Status status;
    call_->Finish(&status, nullptr);
    queue_.Shutdown();
    void* tag = nullptr;
    bool ok = false;
    while (queue_.Next(&tag, &ok)) {
    }
  }

  v1::DetectStreamResponse Exchange(const std::string& bytes) {
    const grpc::Slice slice(bytes);
    call_->Write(grpc::ByteBuffer(&slice, 1), nullptr);
    Wait();
    grpc::ByteBuffer answer;
    call_->Read(&answer, nullptr);
    Wait();
    v1::DetectStreamResponse response;
    grpc::SerializationTraits<v1::DetectStreamResponse>::Deserialize(&answer, &response);
    return response;
  }

 private:
  void Wait() {
    void* tag = nullptr;
    bool ok = false;
    EXPECT_TRUE(queue_.Next(&tag, &ok) && ok);
  }

  grpc::GenericStub stub_;
  grpc::ClientContext context_;
  grpc::CompletionQueue queue_;
  std::unique_ptr<grpc::GenericClientAsyncReaderWriter> call_;
};

}  // namespace fovea::testing
