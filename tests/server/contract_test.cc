// What answers and errors say beside what was found: who made them, what to change, when to return.
#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <grpcpp/create_channel.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "core/options.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"
#include "server/build_info.h"
#include "server/error_details.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// Of a call with a stub, whose status has all that the server sent.
grpc::Status Detect(const Loopback& loopback, const v1::DetectRequest& request,
                    const std::string& token = "") {
  const auto stub = v1::DetectionService::NewStub(
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  if (!token.empty()) context.AddMetadata("authorization", "Bearer " + token);
  v1::DetectResponse response;
  return stub->Detect(&context, request, &response);
}

// The only detail, which must be one of these.
template <typename Detail>
Detail DetailOf(const grpc::Status& status) {
  google::rpc::Status details;
  EXPECT_TRUE(details.ParseFromString(status.error_details()));
  EXPECT_EQ(details.code(), status.error_code());
  EXPECT_EQ(details.message(), status.error_message());
  EXPECT_EQ(details.details_size(), 1);
  Detail detail;
  EXPECT_TRUE(details.details(0).UnpackTo(&detail));
  return detail;
}

v1::DetectRequest WithTime(std::int64_t time_s, int nanos) {
  v1::DetectRequest request = TestRequest();
  request.mutable_frame()->mutable_captured_at()->set_seconds(time_s);
  request.mutable_frame()->mutable_captured_at()->set_nanos(nanos);
  return request;
}

TEST(Contract, AnswersSayWhatMadeThem) {
  const Loopback loopback(FindOne);
  const v1::Detections detections = loopback.client.Detect(TestRequest()).detections();
  EXPECT_EQ(detections.server_version(), server::Version());
  EXPECT_EQ(detections.server_build(), server::Commit());
  EXPECT_EQ(detections.server_version(), loopback.client.GetServerInfo().version());
  EXPECT_THAT(server::Commit(), ::testing::MatchesRegex("unknown|[0-9a-f]{12}(-modified)?"));
}

TEST(Contract, ErrorsNameTheFieldForPrograms) {
  const Loopback loopback(FindOne);
  v1::DetectRequest request = TestRequest();
  request.mutable_frame()->mutable_depth()->set_data("short");
  const grpc::Status status = Detect(loopback, request);
  const auto detail = DetailOf<google::rpc::BadRequest>(status);
  ASSERT_EQ(detail.field_violations_size(), 1);
  EXPECT_EQ(detail.field_violations(0).field(), "frame.depth.data");
  EXPECT_EQ("frame.depth.data: " + detail.field_violations(0).description(),
            status.error_message());
  try {
    loopback.client.Detect(request);
    FAIL() << "the call succeeded";
  } catch (const client::RpcError& error) {
    EXPECT_EQ(error.field(), "frame.depth.data");
  }
}

TEST(Contract, FieldsArePathsOfTheRequest) {
  const auto field_of = [](const char* path) {
    const grpc::Status status = server::InvalidArgument({path, "is: wrong"});
    EXPECT_EQ(status.error_message(), std::string(path) + ": is: wrong");
    return server::FieldOf(status);
  };
  for (const char* path :
       {"frame", "frame.depth.data", "options.parameters[a.b]", "options.parameters[a: b]",
        "options.parameters[a]: b]", "options.parameters[a, b]", "options.parameters[]",
        "options.grasps.grippers[7].max_tilt_rad", "options.grasps.grippers[0].jaw.palm_size",
        "robots", "max_rate_hz", "parts"}) {
    EXPECT_EQ(field_of(path), path);
  }
  EXPECT_EQ(field_of("frame.color.width, height"), "frame.color.width");
  for (const char* other : {"metadata fovea-robot", "framed", "robotics", ""}) {
    EXPECT_EQ(field_of(other), "");
    EXPECT_EQ(server::InvalidArgument({other, "no"}).error_details(), "");
  }
}

TEST(Contract, FieldsHoldIndicesAndNamesOfTheCaller) {
  const Loopback loopback(FindOne);
  v1::DetectRequest request = TestRequest();
  v1::GraspOptions& grasps = *request.mutable_options()->mutable_grasps();
  grasps.add_grippers();
  grasps.add_grippers()->set_max_tilt_rad(2);
  EXPECT_EQ(server::FieldOf(Detect(loopback, request)), "options.grasps.grippers[1].max_tilt_rad");
  grasps.mutable_grippers(1)->clear_max_tilt_rad();
  grasps.mutable_grippers(1)->mutable_suction()->set_diameter_m(-1);
  EXPECT_EQ(server::FieldOf(Detect(loopback, request)),
            "options.grasps.grippers[1].suction.diameter_m");
  grasps.clear_grippers();
  for (const std::string name : {"mrf.no", "mrf: no", "a]: b", "a].b: c", "[", ", "}) {
    (*request.mutable_options()->mutable_parameters())[name] = 1;
    EXPECT_EQ(server::FieldOf(Detect(loopback, request)), "options.parameters[" + name + "]");
    request.mutable_options()->clear_parameters();
  }
  request.mutable_frame()->mutable_intrinsics()->set_fx(0.8);
  EXPECT_EQ(server::FieldOf(Detect(loopback, request)), "frame.intrinsics.fx");
}

// Each may be set, but not for this image or beside the others.
TEST(Contract, OptionsThatLeaveNothingToLookAtAreNamed) {
  const Loopback loopback(FindOne);
  for (const std::string name :
       {"region.x_px", "region.y_px", "region.min_x_m", "region.min_y_m", "region.min_z_m"}) {
    v1::DetectRequest request = TestRequest();
    (*request.mutable_options()->mutable_parameters())[name] = 100;
    const grpc::Status status = Detect(loopback, request);
    EXPECT_EQ(server::FieldOf(status), "options.parameters[" + name + "]");
    EXPECT_THAT(status.error_message(), StartsWith("options.parameters[" + name + "]: 100 "));
  }
}

TEST(Contract, RefusalsSayWhenToReturn) {
  Gate gate;
  server::ServerOptions options = LoopbackOptions();
  options.compute_threads = 1;
  options.max_waiting = 0;
  const Loopback loopback(std::ref(gate), options);
  const std::jthread call([&] { loopback.client.Detect(TestRequest()); });
  gate.WaitUntilBegun();
  const grpc::Status status = Detect(loopback, TestRequest());
  gate.Let();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  const auto delay = DetailOf<google::rpc::RetryInfo>(status).retry_delay();
  EXPECT_GT(delay.seconds() * 1'000'000'000 + delay.nanos(), 0);
}

TEST(Contract, OldStreamsSayThatAnotherOneIsToBeOpenedAtOnce) {
  server::ServerOptions options = LoopbackOptions();
  options.max_connection_age_s = 1;
  const Loopback loopback(FindOne, options);
  const auto stub = v1::DetectionService::NewStub(
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  const auto stream = stub->DetectStream(&context);
  v1::DetectStreamResponse response;
  EXPECT_FALSE(stream->Read(&response));
  const grpc::Status status = stream->Finish();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(DetailOf<google::rpc::RetryInfo>(status).retry_delay().ByteSizeLong(), 0U);
  EXPECT_EQ(context.GetServerTrailingMetadata().count("retry-after-ms"), 1U);
}

template <typename Call>
std::string RequestIdOf(Call call) {
  grpc::ClientContext context;
  context.AddMetadata("fovea-request-id", "mine");
  EXPECT_TRUE(call(&context).ok());
  const auto& metadata = context.GetServerTrailingMetadata();
  const auto found = metadata.find("fovea-request-id");
  return found == metadata.end() ? "" : std::string(found->second.data(), found->second.size());
}

TEST(Contract, EveryCallGivesItsRequestIdBack) {
  const Loopback loopback(FindOne);
  const auto stub = v1::DetectionService::NewStub(
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials()));
  v1::GetServerInfoResponse info;
  EXPECT_EQ(RequestIdOf([&](auto* c) { return stub->GetServerInfo(c, {}, &info); }), "mine");
  v1::GetStatisticsResponse statistics;
  EXPECT_EQ(RequestIdOf([&](auto* c) { return stub->GetStatistics(c, {}, &statistics); }), "mine");
  v1::ListOptionsResponse list;
  EXPECT_EQ(RequestIdOf([&](auto* c) { return stub->ListOptions(c, {}, &list); }), "mine");
}

TEST(Contract, DetailsAreReadBack) {
  const grpc::Status full = server::ResourceExhausted("full", std::chrono::milliseconds(1234));
  EXPECT_EQ(server::RetryAfterOf(full), std::chrono::milliseconds(1234));
  EXPECT_EQ(server::FieldOf(full), "");
  EXPECT_FALSE(server::RetryAfterOf(grpc::Status::OK).has_value());
}

TEST(Contract, FramesOfStreamsNameTheFieldToo) {
  const Loopback loopback(FindOne);
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  (*request.mutable_options()->mutable_parameters())["no.such"] = 1;
  stream->Send(request);
  const auto answer = stream->Receive();
  ASSERT_TRUE(answer && answer->has_error());
  EXPECT_EQ(answer->error().field(), "options.parameters[no.such]");
  EXPECT_FALSE(answer->error().has_retry_after());
}

TEST(Contract, TimesAreThoseThatJsonCanSay) {
  const Loopback loopback(FindOne);
  const auto error_of = [&](std::int64_t time_s, int nanos) {
    return Detect(loopback, WithTime(time_s, nanos)).error_message();
  };
  EXPECT_THAT(error_of(253402300800, 0), StartsWith("frame.captured_at: is 253402300800 s"));
  EXPECT_THAT(error_of(-62135596801, 0), StartsWith("frame.captured_at: is -62135596801 s"));
  EXPECT_THAT(error_of(0, 1'000'000'000), StartsWith("frame.captured_at: has 1000000000 nanos"));
  EXPECT_THAT(error_of(0, -1), StartsWith("frame.captured_at: has -1 nanos"));
  for (const v1::DetectRequest& good :
       {WithTime(253402300799, 999'999'999), WithTime(-62135596800, 0)}) {
    std::string json;
    EXPECT_TRUE(
        google::protobuf::util::MessageToJsonString(loopback.client.Detect(good), &json).ok());
    EXPECT_THAT(json, HasSubstr("capturedAt"));
  }
}

TEST(Contract, ListsTheOptions) {
  const Loopback loopback(FindOne);
  const v1::ListOptionsResponse list = loopback.client.ListOptions();
  ASSERT_EQ(static_cast<std::size_t>(list.options_size()), ListOptions().size());
  std::map<std::string, v1::Option> options;
  for (const v1::Option& option : list.options()) options[option.name()] = option;
  const v1::Option& gamma = options.at("mrf.gamma_per_m2");
  EXPECT_EQ(gamma.unit(), "1/m2");
  EXPECT_EQ(gamma.minimum(), 0.1);
  EXPECT_EQ(gamma.maximum(), 10000);
  EXPECT_FALSE(gamma.integral());
  EXPECT_EQ(gamma.defaults().at("paper"), 180);
  EXPECT_EQ(gamma.defaults().at("default"), OptionValues(OptionsOfProfile("")).at(gamma.name()));
  EXPECT_THAT(gamma.description(), HasSubstr("Eq. 5"));
  EXPECT_EQ(options.at("max_depth_m").unit(), "m");
  EXPECT_EQ(options.at("gravity.coarse_angle_deg").unit(), "deg");
  EXPECT_EQ(options.at("support.min_area_m2").unit(), "m2");
  EXPECT_EQ(options.at("seeds.disk_radius_px").unit(), "px");
  EXPECT_EQ(options.at("objects.max_objects").unit(), "");
  EXPECT_TRUE(options.at("objects.max_objects").integral());
}

}  // namespace
}  // namespace fovea::testing
