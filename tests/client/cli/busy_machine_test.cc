#include "client/cli/busy_machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fovea::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

v1::GetStatisticsResponse Statistics(int waited_s) {
  v1::GetStatisticsResponse statistics;
  auto& stages = *statistics.mutable_stages();
  stages["queue"].mutable_total()->set_seconds(50);
  stages["decode"].mutable_total()->set_seconds(50);
  stages["normals"].mutable_total()->set_seconds(4);
  stages["objects"].mutable_total()->set_seconds(5);
  stages["processor_wait"].mutable_total()->set_seconds(waited_s);
  return statistics;
}

TEST(NoteOfBusyMachine, SaysWhatOthersTook) {
  EXPECT_THAT(NoteOfBusyMachine(Statistics(6)), HasSubstr("of 9.0 s that frames took, the server "
                                                          "waited 6.0 s for a processor"));
  EXPECT_THAT(NoteOfBusyMachine(Statistics(6)),
              HasSubstr("other programs of its machine, or more threads than it has processors"));
}

TEST(NoteOfBusyMachine, IsEmptyWhereItIsLittle) {
  EXPECT_THAT(NoteOfBusyMachine(Statistics(3)), IsEmpty());
  EXPECT_THAT(NoteOfBusyMachine(v1::GetStatisticsResponse()), IsEmpty());
}

TEST(ProcessorWait, OfAnAnswer) {
  v1::Detections detections;
  const auto add = [&](const char* stage, int nanos) {
    v1::StageTime& time = *detections.add_stage_times();
    time.set_stage(stage);
    time.mutable_duration()->set_nanos(nanos);
  };
  add("decode", 500'000'000);
  add("normals", 100'000'000);
  add("processor_wait", 40'000'000);
  const ProcessorWait wait = ProcessorWaitOf(detections);
  EXPECT_DOUBLE_EQ(wait.took_s, 0.1);
  EXPECT_DOUBLE_EQ(wait.waited_s, 0.04);
  EXPECT_TRUE(wait.IsMuch());
}

}  // namespace
}  // namespace fovea::cli
