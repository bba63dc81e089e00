// fovea-load: many simulated robots against a running server; what it prints is what
// docs/operations.md reports.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <future>
#include <iostream>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "client/cli/progress.h"
#include "client/images.h"
#include "flags/misspelling.h"
#include "tests/load/plans.h"
#include "tests/load/process_watch.h"
#include "tests/load/report.h"
#include "tests/load/robot.h"
#include "tests/load/saboteur.h"
#include "tests/load/stop_signals.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace {

using fovea::load::Flags;
using fovea::load::Links;
using fovea::load::Outcome;
using fovea::load::RobotPlan;

void AddFlags(CLI::App& app, Flags& flags) {
  app.add_option("--server", flags.server, "Address of the server; several with commas between")
      ->capture_default_str();
  app.add_option("--hold", flags.hold,
                 "So many robots hold to the first server, so many to the second, …; else the "
                 "client chooses")
      ->delimiter(',');
  app.add_flag("--turns", flags.turns,
               "Robots ask the servers in turns, call by call or, with --stream, one by one");
  app.add_option("--robots", flags.robots, "How many")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--seconds", flags.seconds, "How long")
      ->check(CLI::Range(1, 86'400))
      ->capture_default_str();
  app.add_option("--warm-up", flags.warm_up, "Seconds before that, of which nothing is counted")
      ->check(CLI::Range(0, 3600))
      ->capture_default_str();
  app.add_option("--rate", flags.rate_hz,
                 "Frames per second of each robot; 0: the next as soon as the last is answered")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  app.add_option("--greedy", flags.greedy, "The first robot sends this many times as often")
      ->check(CLI::Range(1.0, 1000.0));
  app.add_option("--greedy-calls", flags.greedy_calls,
                 "One robot more has so many calls at once, each again as soon as it is answered, "
                 "or when the server says")
      ->check(CLI::Range(0, 1000));
  app.add_option("--slow-link", flags.slow_kb_per_s,
                 "One robot more has a link of so many kB/s to the server")
      ->check(CLI::Range(0, 1'000'000));
  app.add_flag("--vanish", flags.vanish,
               "One robot more vanishes without a word when half of the time is over");
  app.add_flag(
      "--retry", flags.retry,
      "Robots repeat what was refused as the client library does, and their streams resume; the "
      "latency is that of all attempts");
  app.add_flag("--stream", flags.stream, "Streams instead of single calls");
  app.add_option("--saboteurs", flags.saboteurs,
                 "So many others that send damaged frames, vanish, do not read their answers …")
      ->check(CLI::Range(0, 100));
  app.add_option(
      "--pid", flags.pid,
      "Process of the server, if it runs on this machine: prints its memory, threads and "
      "open files every minute");
  app.add_option("--kind", flags.kind, "Kind of the generated scene, as for fovea-scenes")
      ->capture_default_str();
  app.add_option("--size", flags.size_px, "Pixels of a frame, as WIDTHxHEIGHT; else 640x480")
      ->delimiter('x')
      ->expected(2)
      ->check(CLI::Range(16, 4096));
}

// Raw; 640x480 are 1.5 MB.
fovea::v1::Frame MakeFrame(const std::string& kind, const cv::Size& size_px) {
  const auto scene = fovea::scenes::RandomScene(kind, /*seed=*/7, size_px);
  const fovea::RgbdFrame rgbd =
      fovea::scenes::MakeFrame(scene, fovea::scenes::SensorKind::kKinect, 7).frame;
  const auto width = static_cast<std::uint32_t>(rgbd.depth_m.cols);
  const auto height = static_cast<std::uint32_t>(rgbd.depth_m.rows);
  cv::Mat millimeters;
  rgbd.depth_m.convertTo(millimeters, CV_16UC1, 1000);  // NaN becomes 0
  fovea::v1::Frame frame;
  *frame.mutable_color() = fovea::client::MakeColorImage(rgbd.color_rgb.data, width, height,
                                                         fovea::v1::COLOR_ENCODING_RGB8);
  *frame.mutable_depth() =
      fovea::client::MakeDepthImage(millimeters.ptr<std::uint16_t>(), width, height);
  *frame.mutable_intrinsics() = fovea::client::MakeIntrinsics(
      rgbd.intrinsics.fx_px, rgbd.intrinsics.fy_px, rgbd.intrinsics.cx_px, rgbd.intrinsics.cy_px);
  return frame;
}

void Print(const std::map<std::string, std::uint64_t>& deeds) {
  for (const auto& [name, count] : deeds) std::cout << count << ' ' << name << '\n';
}

// Lets the time pass, with a bar and, where a process is watched, a line a minute. Returns how many
// seconds it were, fewer where it is told to stop.
int Wait(const Flags& flags, const fovea::load::StopSignals& stop_signals) {
  constexpr int kSecondsPerMinute = 60;
  const int seconds = flags.warm_up + flags.seconds;
  fovea::cli::Progress progress(static_cast<std::size_t>(seconds),
                                fovea::cli::Progress::Stream::kError);
  const auto start = std::chrono::steady_clock::now();
  for (int second = 0; second < seconds; ++second) {
    if (flags.pid > 0 && second % kSecondsPerMinute == 0) {
      std::cout << second / kSecondsPerMinute
                << " min: " << fovea::load::SizeOfProcess(flags.pid).Text() << std::endl;
    }
    if (stop_signals.ComeUntil(start + std::chrono::seconds(second + 1))) {
      progress.Finish();
      std::cerr << "stopped after " << second << " of " << seconds << " s\n";
      return second;
    }
    progress.Advance(std::to_string(flags.robots) + " robots");
  }
  progress.Finish();
  return seconds;
}

using Deeds = std::map<std::string, std::uint64_t>;

std::vector<std::future<Deeds>> StartSaboteurs(const Flags& flags, const fovea::v1::Frame& frame,
                                               const std::stop_token& stop) {
  std::vector<std::future<Deeds>> saboteurs;
  saboteurs.reserve(static_cast<std::size_t>(flags.saboteurs));
  for (int i = 0; i < flags.saboteurs; ++i) {
    saboteurs.push_back(std::async(std::launch::async, [&, stop, i] {
      return fovea::load::RunSaboteur(flags.server, frame, static_cast<unsigned>(i) + 1, stop);
    }));
  }
  return saboteurs;
}

std::vector<std::future<Outcome>> StartRobots(const std::vector<RobotPlan>& plans,
                                              const std::stop_token& stop) {
  std::vector<std::future<Outcome>> robots;
  robots.reserve(plans.size());
  for (const RobotPlan& plan : plans) {
    robots.push_back(std::async(std::launch::async,
                                [&plan, stop] { return fovea::load::RunRobot(plan, stop); }));
  }
  return robots;
}

// Cuts the link when half of the time is over, unless it is told to stop before.
std::jthread CutLater(const Flags& flags, Links* links) {
  if (!links->vanishing) return {};
  const std::chrono::milliseconds wait(1000 * flags.warm_up + 500 * flags.seconds);
  return std::jthread([wait, links](const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_for(lock, stop, wait, [] { return false; });
    links->vanishing->Cut();
  });
}

struct Run {
  std::vector<Outcome> outcomes;
  int seconds = 0;  // of which is told, without the warm-up
};

Run RunAll(const Flags& flags) {
  const fovea::load::StopSignals stop_signals;
  const fovea::v1::Frame frame = MakeFrame(flags.kind, {flags.size_px[0], flags.size_px[1]});
  Links links;
  std::vector<RobotPlan> plans = fovea::load::MakePlans(flags, frame, &links);
  fovea::load::WaitForServers(plans);  // else the robots fail when all of the time is over
  // A server that starts late takes nothing of the warm-up.
  const auto noted_from = std::chrono::steady_clock::now() + std::chrono::seconds(flags.warm_up);
  for (RobotPlan& plan : plans) plan.noted_from = noted_from;
  std::stop_source stop;
  const std::jthread cutting = CutLater(flags, &links);
  auto saboteurs = StartSaboteurs(flags, frame, stop.get_token());
  auto robots = StartRobots(plans, stop.get_token());
  Run run;
  try {
    run.seconds = std::max(0, Wait(flags, stop_signals) - flags.warm_up);
  } catch (...) {  // the futures wait for their robots, whatever happens
    stop.request_stop();
    throw;
  }
  stop.request_stop();
  run.outcomes.reserve(robots.size());
  for (auto& robot : robots) run.outcomes.push_back(robot.get());
  for (auto& saboteur : saboteurs) Print(saboteur.get());
  return run;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Simulates robots that send frames to a fovea server.", "fovea-load");
  Flags flags;
  AddFlags(app, flags);
  fovea::flags::NameMisspellings(app, argc, argv);
  CLI11_PARSE(app, argc, argv);
  const Run run = RunAll(flags);
  if (run.seconds == 0) throw std::runtime_error("stopped before anything was counted");
  std::cout << fovea::load::Report(run.outcomes, run.seconds);
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << "fovea-load: " << error.what() << '\n';
  return EXIT_FAILURE;
}
