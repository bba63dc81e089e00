#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/server_context.h>
#include <grpcpp/support/async_stream.h>
#include <grpcpp/support/byte_buffer.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "server/rpc/caller.h"
#include "server/rpc/detection_service.h"
#include "server/rpc/newest_frame.h"
#include "server/rpc/stream_options.h"
#include "server/rpc/transfer_limit.h"
#include "server/stream_tracker.h"

namespace fovea::server {

// One call of DetectStream. One frame is worked on, the newest one waits, those in between are
// dropped: it reads all the time, and when its turn comes takes what came last.
class StreamCall : public std::enable_shared_from_this<StreamCall> {
 public:
  // Waits for a stream, and for the next one when that came.
  static void Accept(const CallEnvironment& environment);

  explicit StreamCall(const CallEnvironment& environment);
  ~StreamCall();

 private:
  void OnRequest();
  void Open();  // mutex_ is held
  // The stream is not let in; mutex_ is held. `reason` is what it is counted as.
  void Refuse(const grpc::Status& status, const char* reason);
  void Read();
  void OnRead();
  void OnNoMore();
  void OnGone();
  void OnWritten(bool ok);
  void End();          // by the server
  void Check();        // whether the caller may still call
  void CheckAccess();  // mutex_ is held
  void LimitAge();
  void DeliverOrEnd();
  void Deliver();
  void ComputeOrSayWhyNot();  // the newest frame into response_
  grpc::Status Compute(ReceivedFrame& received, std::chrono::steady_clock::time_point began);
  void Proceed();                     // whatever comes next; mutex_ is held
  void TakeTurn();                    // mutex_ is held
  grpc::Status StatusOfGone() const;  // whoever has ended it
  void Finish(const grpc::Status& status);

  const CallEnvironment& environment_;
  const LiveCalls::Token token_;
  LiveCalls::Token begun_;
  StreamPlaces::Place place_;
  grpc::ServerContext context_;
  Caller caller_;
  TransferLimit transfer_;  // of answers: frames come as they come
  grpc::ServerAsyncReaderWriter<grpc::ByteBuffer, grpc::ByteBuffer> stream_{&context_};
  grpc::ByteBuffer bytes_;             // of the message that is being read
  v1::DetectStreamResponse response_;  // of the frame that is worked on
  StreamOptions options_;              // that hold
  StreamTracker tracker_;              // of the frames that were answered
  PickBoard::Listening listening_;     // null where the stream takes no picks
  PickBoard::TakenPtr pick_;           // in response_

  std::mutex mutex_;
  NewestFrame newest_;
  Scheduler::Ticket ticket_ = 0;
  bool busy_ = false;     // waits for its turn, computes or writes
  bool no_more_ = false;  // the caller sends no more frames
  bool ending_ = false;   // the server is stopping
  bool is_old_ = false;   // the caller is to open another one
  grpc::Alarm age_;
  bool broken_ = false;                 // an answer could not be sent
  std::optional<grpc::Status> barred_;  // why the caller may not call any more
  bool finished_ = false;
};

}  // namespace fovea::server
