// Spans of frames, as a collector of OpenTelemetry gets them over HTTP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "server/tracing/refused_spans.h"
#include "server/tracing/tracer.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"
#include "tests/server/span_collector.h"

namespace fovea::testing {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kTraceId[] = "0af7651916cd43dd8448eb211c80319c", kParentId[] = "b7ad6b7169203331";

std::string Traceparent(const char* flags) {
  return std::string("00-") + kTraceId + "-" + kParentId + "-" + flags;
}

server::ServerOptions TracingTo(const std::string& url, double share = 1) {
  server::ServerOptions options = LoopbackOptions();
  options.trace_endpoint = url;
  options.trace_share = share;
  return options;
}

// One call of a caller that is part of a trace; no `traceparent`: it is not.
grpc::Status Detect(const Loopback& loopback, const std::string& traceparent,
                    const v1::DetectRequest& request = TestRequest()) {
  client::ClientOptions options = PatientOptions();
  options.robot = "kitchen";
  const client::Client kitchen(loopback.server.Address(), options);
  try {
    kitchen.Detect(request, {.traceparent = traceparent});
    return grpc::Status::OK;
  } catch (const client::RpcError& error) {
    return {error.code(), error.message()};
  }
}

std::vector<std::string> NamesOf(const std::vector<json>& spans) {
  std::vector<std::string> names;
  for (const json& span : spans) names.push_back(span.at("name"));
  return names;
}

std::int64_t Nanoseconds(const json& span, const char* key) {
  return std::stoll(span.at(key).get<std::string>());
}

std::map<std::string, std::string> AttributesOf(const json& of) {
  std::map<std::string, std::string> attributes;
  for (const json& each : of.at("attributes")) {
    attributes[each.at("key")] = each.at("value").begin().value();
  }
  return attributes;
}

TEST(Traceparent, IsReadAsTheStandardSays) {
  const auto context = server::ParseTraceparent(Traceparent("01"));
  ASSERT_TRUE(context);
  EXPECT_EQ(server::HexOf(context->trace_id), kTraceId);
  EXPECT_EQ(server::HexOf(context->parent), kParentId);
  EXPECT_TRUE(context->sampled);
  EXPECT_FALSE(server::ParseTraceparent(Traceparent("02"))->sampled);
  EXPECT_TRUE(server::ParseTraceparent("cc" + Traceparent("01").substr(2) + "-later")->sampled);
}

TEST(Traceparent, IsIgnoredWhereItIsMalformed) {
  const std::string good = Traceparent("01");
  std::string upper = good, zero_trace = good, zero_parent = good, no_dash = good;
  upper[4] = 'A';
  zero_trace.replace(3, 32, 32, '0');
  zero_parent.replace(36, 16, 16, '0');
  no_dash[35] = '0';
  for (const std::string& bad :
       {std::string(), good.substr(1), good + "-more", good + "x", "ff" + good.substr(2),
        "cc" + good.substr(2) + "x", upper, zero_trace, zero_parent, no_dash}) {
    EXPECT_FALSE(server::ParseTraceparent(bad)) << bad;
  }
}

TEST(Tracing, SendsTheFrameAndItsStages) {
  SpanCollector collector;
  const Loopback loopback(FindOne, TracingTo(collector.url()));
  EXPECT_TRUE(Detect(loopback, Traceparent("01")).ok());
  const std::vector<json> spans = collector.Next();
  ASSERT_THAT(NamesOf(spans), ElementsAre("fovea.frame", "queue", "decode", "first"));
  const json& frame = spans[0];
  EXPECT_EQ(frame.at("parentSpanId"), kParentId);
  EXPECT_EQ(frame.at("kind"), 2);
  EXPECT_FALSE(frame.contains("status"));
  const auto attributes = AttributesOf(frame);
  EXPECT_EQ(attributes.at("fovea.robot"), "kitchen");
  EXPECT_EQ(attributes.at("fovea.frame_id"), "frame-7");
  EXPECT_EQ(attributes.at("fovea.objects"), "1");
  for (const json& span : spans) EXPECT_EQ(span.at("traceId"), kTraceId);
  for (std::size_t i = 1; i < spans.size(); ++i) {
    EXPECT_EQ(spans[i].at("parentSpanId"), frame.at("spanId"));
  }
  EXPECT_EQ(spans[1].at("startTimeUnixNano"), frame.at("startTimeUnixNano"));
  EXPECT_EQ(spans[3].at("startTimeUnixNano"), spans[2].at("endTimeUnixNano"));
  EXPECT_EQ(Nanoseconds(spans[3], "endTimeUnixNano") - Nanoseconds(spans[3], "startTimeUnixNano"),
            1'500'000);
  EXPECT_EQ(AttributesOf(collector.resource()).at("service.name"), "fovea-server");
  AwaitMetric(*loopback.server.metrics(), "fovea_traces_sent_total", 1);
}

TEST(Tracing, SaysWhatWentWrong) {
  SpanCollector collector;
  const Loopback loopback(FindOne, TracingTo(collector.url()));
  EXPECT_FALSE(Detect(loopback, Traceparent("01"), {}).ok());
  const std::vector<json> spans = collector.Next();
  EXPECT_EQ(spans[0].at("status").at("code"), 2);
  EXPECT_EQ(spans[0].at("status").at("message"), "INVALID_ARGUMENT: frame: is missing");
  EXPECT_EQ(AttributesOf(spans[0]).at("rpc.grpc.status_code"), "3");
}

TEST(Tracing, HasTheStagesOfAFrameThatWasCutOff) {
  SpanCollector collector;
  const auto cut_off = [](const auto&, const auto&, Trace*, const auto&) -> Detections {
    Cancelled cancelled("normals");
    cancelled.stage_times = {{"depth", 2.0}, {"normals", 30.0}};
    throw cancelled;
  };
  const Loopback loopback(cut_off, TracingTo(collector.url()));
  EXPECT_FALSE(Detect(loopback, Traceparent("01")).ok());
  EXPECT_THAT(NamesOf(collector.Next()),
              ElementsAre("fovea.frame", "queue", "decode", "depth", "normals"));
}

TEST(Tracing, LeavesOutWhatTheCallerDoesNotRecord) {
  SpanCollector collector;
  const Loopback loopback(FindOne, TracingTo(collector.url()));
  EXPECT_TRUE(Detect(loopback, Traceparent("00")).ok());
  EXPECT_TRUE(Detect(loopback, Traceparent("01")).ok());
  EXPECT_EQ(collector.Next().size(), 4U);
}

TEST(Tracing, BeginsTracesOfItsOwn) {
  SpanCollector collector;
  const Loopback loopback(FindOne, TracingTo(collector.url()));
  EXPECT_TRUE(Detect(loopback, "malformed").ok());
  const std::vector<json> spans = collector.Next();
  EXPECT_EQ(spans[0].at("traceId").get<std::string>().size(), 32U);
  EXPECT_NE(spans[0].at("traceId"), kTraceId);
  EXPECT_FALSE(spans[0].contains("parentSpanId"));
}

TEST(Tracing, BeginsNoneWhereTheShareIsZero) {
  SpanCollector collector;
  const Loopback loopback(FindOne, TracingTo(collector.url(), 0));
  EXPECT_TRUE(Detect(loopback, "").ok());
  EXPECT_TRUE(Detect(loopback, Traceparent("01")).ok());
  const std::vector<json> spans = collector.Next();
  EXPECT_EQ(spans.size(), 4U);
  EXPECT_EQ(spans[0].at("traceId"), kTraceId);
}

TEST(Tracing, FramesOfAStreamBelongToItsCall) {
  SpanCollector collector;
  const Loopback loopback(FindOne, TracingTo(collector.url()));
  const auto stream = loopback.client.OpenStream(kPatience, {.traceparent = Traceparent("01")});
  std::vector<json> spans;
  for (int i = 0; i < 2; ++i) {
    v1::DetectStreamRequest request;
    *request.mutable_frame() = TestFrame();
    ASSERT_TRUE(stream->Send(request) && stream->Receive());
  }
  while (spans.size() < 8) {
    for (const json& span : collector.Next()) spans.push_back(span);
  }
  EXPECT_EQ(spans[0].at("parentSpanId"), kParentId);
  EXPECT_EQ(spans[4].at("parentSpanId"), kParentId);
  EXPECT_NE(spans[0].at("spanId"), spans[4].at("spanId"));
}

TEST(Tracing, GoesOnWithoutACollector) {
  asio::io_context context;
  std::string nowhere;
  {
    const tcp::acceptor closed(context, FreePort());
    nowhere = Url(closed);
  }
  const Loopback loopback(FindOne, TracingTo(nowhere));
  EXPECT_TRUE(Detect(loopback, "").ok());
  AwaitMetric(*loopback.server.metrics(), "fovea_traces_dropped_total", 1);
  EXPECT_TRUE(Detect(loopback, "").ok());
}

TEST(Tracing, CountsWhatTheCollectorRefusesAndSaysSoOnce) {
  const CapturedLog log;
  SpanCollector collector(R"({"partialSuccess":{"rejectedSpans":"1","errorMessage":"no\nroom"}})");
  const Loopback loopback(FindOne, TracingTo(collector.url()));
  EXPECT_TRUE(Detect(loopback, "").ok());
  AwaitMetric(*loopback.server.metrics(), "fovea_traces_dropped_total", 1);
  EXPECT_TRUE(Detect(loopback, "").ok());
  AwaitMetric(*loopback.server.metrics(), "fovea_traces_dropped_total", 2);
  EXPECT_EQ(MetricValue(*loopback.server.metrics(), "fovea_traces_sent_total"), 0);
  const std::string once = " refuses 1 of 4 spans: \"no?room\"";
  EXPECT_THAT(log.text(), HasSubstr(once));
  EXPECT_THAT(log.text().substr(log.text().find(once) + once.size()), Not(HasSubstr("refuses")));
}

TEST(RefusedSpans, AreReadFromTheAnswer) {
  const auto read = [](const char* answer) {
    const server::RefusedSpans refused = server::RefusedSpansIn(answer);
    return std::to_string(refused.count) + " " + refused.reason;
  };
  EXPECT_EQ(read(R"({"partialSuccess":{"rejectedSpans":"26","errorMessage":"no"}})"), "26 no");
  EXPECT_EQ(read(R"({"partialSuccess":{"rejectedSpans":26}})"), "26 ");
  EXPECT_EQ(read(R"({"partialSuccess":{"rejectedSpans":"0","errorMessage":"soon"}})"), "0 soon");
  for (const char* none :
       {"", "{}", "[]", "{", "ok", R"({"partialSuccess":3})", R"({"partialSuccess":{}})",
        R"({"partialSuccess":{"rejectedSpans":"x","errorMessage":3}})",
        R"({"partialSuccess":{"rejectedSpans":-1}})",
        R"({"partialSuccess":{"rejectedSpans":[]}})"}) {
    EXPECT_EQ(read(none), "0 ") << none;
  }
}

// That this ends is the test: the collector takes connections and never answers.
TEST(Tracing, WaitsForNoCollector) {
  asio::io_context context;
  const tcp::acceptor stalled(context, FreePort());
  server::Tracer tracer(Url(stalled), 1);
  const std::string name = "x";
  const std::optional<server::TraceContext> no_parent;
  constexpr std::uint64_t kFrames = 5000, kMaxHeld = 1024;  // twice what may wait
  for (std::uint64_t i = 0; i < kFrames; ++i) {
    tracer.OnFrame({name, name, name, no_parent, grpc::Status::OK, {}, std::chrono::seconds(1)});
  }
  EXPECT_GE(tracer.exporter().num_dropped(), kFrames - kMaxHeld);
  EXPECT_EQ(tracer.exporter().num_sent(), 0U);
}

TEST(Tracing, ReplacesWhatIsNoText) {
  const std::string name = "caf\xE9";
  const std::optional<server::TraceContext> no_parent;
  const auto spans = server::SpansOf(
      {name, name, name, no_parent, grpc::Status::OK, {}, std::chrono::seconds(1)}, {});
  EXPECT_THAT(server::OtlpJson({spans}), HasSubstr("caf\xEF\xBF\xBD"));
}

}  // namespace
}  // namespace fovea::testing
