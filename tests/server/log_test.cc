// Log lines, their limits, and readers that stall or go.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "server/logging/line_sink.h"
#include "server/logging/line_writer.h"
#include "server/logging/log_format.h"
#include "server/logging/log_limiter.h"
#include "server/logging/log_record.h"
#include "tests/server/captured_log.h"

namespace fovea::testing {
namespace {

using server::Harmless;
using server::LineSink;
using server::LineWriter;
using server::LogFormat;
using server::LogLimiter;
using server::LogRecord;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

// Whose writing end is as blocking as that of a shell's pipe.
class Pipe {
 public:
  enum Kind { kPipe, kSocket };

  explicit Pipe(Kind kind) {
    const int failed = kind == kPipe
                           ? pipe2(ends_.data(), O_CLOEXEC)
                           : socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_.data());
    EXPECT_EQ(failed, 0);
  }
  ~Pipe() {
    CloseReader();
    close(ends_[1]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int writer() const { return ends_[1]; }
  void CloseReader() {
    if (ends_[0] >= 0) close(std::exchange(ends_[0], -1));
  }
  // What is in it.
  std::string Read() const {
    fcntl(ends_[0], F_SETFL, O_NONBLOCK);
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t size; (size = read(ends_[0], buffer.data(), buffer.size())) > 0;) {
      text.append(buffer.data(), static_cast<std::size_t>(size));
    }
    return text;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

class LogReader : public ::testing::TestWithParam<Pipe::Kind> {
 protected:
  void SetUp() override { signal(SIGPIPE, SIG_IGN); }  // as the server does

  Pipe pipe_{GetParam()};
};

TEST_P(LogReader, ThatStallsHoldsUpNobody) {
  const auto sink = std::make_shared<LineSink>(pipe_.writer());
  spdlog::logger logger("log", sink);
  logger.set_pattern("%v");
  for (int i = 0; i < 10'000; ++i) logger.info("{:05} {}", i, std::string(100, 'x'));
  const std::string seen = pipe_.Read();
  const auto written = std::count(seen.begin(), seen.end(), '\n');
  EXPECT_GT(written, 100);
  EXPECT_LT(written, 10'000);

  logger.info("late");
  const std::string then = pipe_.Read();
  EXPECT_THAT(then, EndsWith(std::to_string(10'000 - written) +
                             " lines dropped, since nobody took them from the log\nlate\n"));
  // No line is mixed up with another.
  std::istringstream lines(seen + then);
  int number = 0;
  for (std::string line; std::getline(lines, line) && number < written; ++number) {
    EXPECT_THAT(line, StartsWith(fmt::format("{:05} x", number)));
  }
}

TEST_P(LogReader, ThatHasGoneEndsNobody) {
  pipe_.CloseReader();
  spdlog::logger logger("log", std::make_shared<LineSink>(pipe_.writer()));
  for (int i = 0; i < 10; ++i) logger.info("to nobody");
  EXPECT_FALSE(LineWriter(pipe_.writer()).Write("to nobody\n"));
}

TEST_P(LogReader, GetsLongLinesWhole) {
  const std::string line = std::string(20'000, 'x') + "\n";
  EXPECT_TRUE(LineWriter(pipe_.writer()).Write(line));
  EXPECT_EQ(pipe_.Read(), line);
}

TEST_P(LogReader, SeesWhereALineWasCut) {
  LineWriter writer(pipe_.writer());
  std::string line(9'000, 'x');  // in two steps, which GCC 12 with sanitizers follows
  line += '\n';
  while (writer.Write(line)) {
  }
  const std::string seen = pipe_.Read();
  EXPECT_TRUE(writer.Write("next\n"));
  const std::string then = pipe_.Read();
  EXPECT_EQ(then, seen.ends_with('\n') ? "next\n" : "\nnext\n");
}

INSTANTIATE_TEST_SUITE_P(Log, LogReader, ::testing::Values(Pipe::kPipe, Pipe::kSocket));

TEST(LogLimiter, LeavesOutWhatIsTooMuchAndSaysHowMuch) {
  const CapturedLog log;
  LogLimiter limiter;
  const LogLimiter::Clock::time_point start;
  const auto admitted = [&](const std::string& kind, int lines, std::chrono::seconds at) {
    int number = 0;
    for (int i = 0; i < lines; ++i) {
      if (limiter.Admit(kind, spdlog::level::warn, "", start + at)) ++number;
    }
    return number;
  };
  using std::chrono::seconds;
  EXPECT_EQ(admitted("frame CANCELLED", 59'000, seconds(0)), LogLimiter::kLines);
  EXPECT_EQ(admitted("other", 5, seconds(5)), 5);
  EXPECT_EQ(log.text(), "");
  limiter.Summarize(start + seconds(10));
  EXPECT_THAT(log.text(),
              HasSubstr("58980 more like this in 10 s: kind=\"frame CANCELLED\" count=58980"));
  EXPECT_EQ(admitted("frame CANCELLED", 5, seconds(11)), 5);
  limiter.Summarize(start + seconds(60));
  EXPECT_THAT(log.text(), Not(HasSubstr("kind=\"other\"")));
}

TEST(LogLimiter, ARobotThatFloodsHidesNoOther) {
  LogLimiter limiter;
  const LogLimiter::Clock::time_point start;
  const auto admits = [&](const std::string& robot) {
    return limiter.Admit("frame INVALID_ARGUMENT", spdlog::level::warn, robot, start);
  };
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(admits("flood"), i < LogLimiter::kLines);
  EXPECT_TRUE(admits("arm"));
  EXPECT_FALSE(admits("arm"));
  EXPECT_FALSE(admits(""));
  // Nor do names by the thousand fill the log.
  int written = 0;
  for (int i = 0; i < 1000; ++i) written += admits("name" + std::to_string(i)) ? 1 : 0;
  EXPECT_EQ(written, LogLimiter::kMostCallers - 1);
}

TEST(LogRecord, TakesTextFromOutsideThatIsHarmless) {
  EXPECT_EQ(Harmless("plain äöü 日本 🤖"), "plain äöü 日本 🤖");
  EXPECT_EQ(Harmless("a\nb\"c\\d\x1B[31m\x7F"), "a?b?c?d?[31m?");
  EXPECT_EQ(Harmless("\xFF\xC3(\xE2\x82"),
            "?"
            "?(?"
            "?");
  EXPECT_EQ(Harmless("\xC0\xAF \xED\xA0\x80 \xF4\x90\x80\x80"), "?? ??? ????");  // no such ones
  EXPECT_EQ(Harmless("\xC2\x9B \xE2\x80\xAE \xE2\x80\xA8"), "? ? ?");
  std::string long_name(299, 'x');
  EXPECT_EQ(LogRecord("e").Text("k", long_name + "äö").AsText(),
            fmt::format("e k=\"{}\"", long_name));
}

TEST(LogRecord, HasTheSameKeysInBothFormats) {
  LogRecord record("frame", "");
  record.Text("request", "17").Word("code", "OK").Number("objects", 3);
  record.Milliseconds("total_ms", 181.24).Text("error", "\"\xFF");
  EXPECT_EQ(record.AsText(), "request=\"17\" code=OK objects=3 total_ms=181.2 error=\"??\"");
  const auto object = nlohmann::json::parse(fmt::format("{{{}}}", record.AsMembers()));
  EXPECT_EQ(object, (nlohmann::json{{"event", "frame"},
                                    {"request", "17"},
                                    {"code", "OK"},
                                    {"objects", 3},
                                    {"total_ms", 181.2},
                                    {"error", "??"}}));
}

std::string Formatted(LogFormat format, const std::string& text) {
  spdlog::memory_buf_t line;
  server::MakeFormatter(format)->format({"log", spdlog::level::warn, text}, line);
  return {line.data(), line.size()};
}

TEST(LogFormat, SaysTheTimeZone) {
  const std::string time = "20[0-9-]+T[0-9:]+\\.[0-9][0-9][0-9][+-][0-9][0-9]:[0-9][0-9]";
  EXPECT_THAT(Formatted(LogFormat::kText, "hello"), MatchesRegex(time + " warning hello\n"));
  const auto object = nlohmann::json::parse(Formatted(LogFormat::kJson, "hello"));
  EXPECT_THAT(object.at("time"), MatchesRegex(time));
}

TEST(LogFormat, JsonIsAnObjectALine) {
  for (const std::string text : {"two\nlines", "\"quoted\"", "no UTF-8: \xFF", ""}) {
    const std::string line = Formatted(LogFormat::kJson, text);
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    const auto object = nlohmann::json::parse(line);
    EXPECT_EQ(object.at("level"), "warning");
    EXPECT_TRUE(object.contains("message"));
  }
  const auto object = nlohmann::json::parse(
      Formatted(LogFormat::kJson, fmt::format("{}{}", server::kMembersFollow,
                                              LogRecord("slow").Word("code", "OK").AsMembers())));
  EXPECT_EQ(object.at("event"), "slow");
  EXPECT_EQ(object.at("code"), "OK");
  EXPECT_FALSE(object.contains("message"));
}

}  // namespace
}  // namespace fovea::testing
