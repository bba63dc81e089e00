// fovea-bench: the profiles and their peers side by side, in one process and one run.
#include <fmt/printf.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/options.h"
#include "core/types/helpers.h"
#include "flags/misspelling.h"
#include "server/compute_process.h"
#include "tests/benchmark/side_by_side/measurement.h"
#include "tests/evaluation/detection_run.h"
#include "tests/evaluation/output.h"
#include "tests/evaluation/statistics.h"
#include "tests/support/data_path.h"

namespace fovea::benchmark {
namespace {

using evaluation::Quantile;

struct Flags {
  std::string data, only, json;
  std::vector<std::string> methods{"default", "paper", "lccp", "plane_clusters"};
  int num_rounds = 5, num_threads = 1;
  std::size_t max_frames = 12;
};

void AddFlags(Flags& flags, CLI::App& app) {
  app.add_option("--data", flags.data,
                 "Folder with osd, osd_whole and real; $FOVEA_DATA or ../shared/data unless given")
      ->check(CLI::ExistingDirectory);
  app.add_option("--only", flags.only, "Sets whose names begin so, such as mOSD or \"real 640\"");
  app.add_option("--methods", flags.methods,
                 "Profiles and peers; ratios are to the first peer of them, else to the first")
      ->delimiter(',')
      ->check(CLI::IsMember(evaluation::DetectionMethodNames()))
      ->capture_default_str();
  app.add_option("--rounds", flags.num_rounds, "How often each frame counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--max-frames", flags.max_frames, "Frames of a set")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--threads-per-frame", flags.num_threads, "Threads for one frame, of the profiles")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--json", flags.json, "Write all figures to this file")
      ->check(evaluation::WhyNotWritable);
}

// What the ratios are to.
std::size_t Reference(const std::vector<std::string>& methods) {
  const std::vector<std::string> profiles = ProfileNames();
  const auto peer = std::find_if(methods.begin(), methods.end(), [&](const std::string& name) {
    return std::find(profiles.begin(), profiles.end(), name) == profiles.end();
  });
  return peer == methods.end() ? 0 : static_cast<std::size_t>(peer - methods.begin());
}

double MedianRatio(const Measurement& own, const Measurement& reference) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(own.frame_ms.size(), reference.frame_ms.size()); ++i) {
    ratios.push_back(own.frame_ms[i] / reference.frame_ms[i]);
  }
  return Quantile(ratios, 0.5);
}

struct Sums {
  double pixels = 0, objects = 0;
};
Sums SumsOf(const FrameSet& set) {
  Sums sums;
  for (const BenchFrame& frame : set.frames) {
    sums.pixels += static_cast<double>(frame.scene.frame.depth_m.total());
    sums.objects += static_cast<double>(frame.num_objects);
  }
  return sums;
}

nlohmann::json Report(const FrameSet& set, const std::vector<Method>& methods,
                      const std::vector<Measurement>& measured, std::size_t reference) {
  const Sums sums = SumsOf(set);
  nlohmann::json json;
  std::cout << fmt::sprintf("\n%s: %d frames, %s\n", set.name, set.frames.size(), set.source);
  std::cout << fmt::sprintf("  %-16s %7s %8s %8s %8s %8s %8s %8s %8s %8s\n", "", "ratio", "median",
                            "p95", "p99", "most", "ns/pixel", "ms/obj.", "allocs", "MB");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Measurement& own = measured[m];
    double total = 0;
    for (const double ms : own.frame_ms) total += ms;
    const auto at = [&](double share) { return Quantile(own.run_ms, share); };
    const double ratio = MedianRatio(own, measured[reference]);
    const double per_object = sums.objects > 0 ? total / sums.objects : 0;
    std::cout << fmt::sprintf("  %-16s %7.2f %8.1f %8.1f %8.1f %8.1f %8.0f %8.1f %8.0f %8.1f",
                              methods[m].name, ratio, Quantile(own.frame_ms, 0.5), at(0.95),
                              at(0.99), at(1), 1e6 * total / sums.pixels, per_object,
                              own.allocations, own.peak_mb);
    if (own.num_failed > 0) std::cout << fmt::sprintf("  refuses %d frames", own.num_failed);
    std::cout << '\n';
    nlohmann::json& row = json[methods[m].name];
    row = {{"ratio", ratio},
           {"median_ms", Quantile(own.frame_ms, 0.5)},
           {"p95_ms", at(0.95)},
           {"p99_ms", at(0.99)},
           {"most_ms", at(1)},
           {"ns_per_pixel", 1e6 * total / sums.pixels},
           {"ms_per_object", per_object},
           {"allocations", own.allocations},
           {"peak_mb", own.peak_mb},
           {"refused", own.num_failed}};
    for (const std::string& stage : own.stages) {
      row["stages"][stage] = Quantile(own.stage_ms.at(stage), 0.5);
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (measured[m].stages.empty()) continue;
    std::cout << "  " << methods[m].name << ':';
    for (const std::string& stage : measured[m].stages) {
      std::cout << fmt::sprintf(" %s %.1f", stage, Quantile(measured[m].stage_ms.at(stage), 0.5));
    }
    std::cout << '\n';
  }
  return json;
}

void Run(const Flags& flags) {
  std::optional<std::filesystem::path> data = DataPath("");
  if (!flags.data.empty()) data = flags.data;
  std::vector<Method> methods;
  for (const std::string& name : flags.methods) methods.push_back(MethodOf(name));
  const std::size_t reference = Reference(flags.methods);
  for (const std::string& name : MissingSets(data)) {
    std::cout << "NOT MEASURED: " << name << ", which is neither in --data nor in $FOVEA_DATA\n";
  }
  std::cout << "ratio: to " << flags.methods[reference]
            << ", median over frames; times in ms, medians over frames, of each over "
            << flags.num_rounds << " rounds; p95 and beyond over all runs\n";
  Helpers helpers(flags.num_threads);
  const Helpers::Scope helped(helpers, flags.num_threads);
  nlohmann::json json;
  for (const FrameSet& set : FrameSets(data, flags.only, flags.max_frames)) {
    std::size_t done = 0;
    const auto measured = Measure(set, methods, flags.num_rounds, [&] {
      evaluation::ShowProgress(set.name, ++done, set.frames.size());
    });
    json[set.name] = Report(set, methods, measured, reference);
  }
  evaluation::WriteJson(flags.json, json);
}

}  // namespace
}  // namespace fovea::benchmark

int main(int argc, char** argv) {
  try {
    fovea::benchmark::Flags flags;
    CLI::App app{"Times the profiles and their peers side by side: ratios first.", "fovea-bench"};
    fovea::benchmark::AddFlags(flags, app);
    fovea::flags::NameMisspellings(app, argc, argv);
    CLI11_PARSE(app, argc, argv);
    fovea::server::SetUpComputing(1);
    fovea::benchmark::Run(flags);
  } catch (const std::exception& error) {
    std::cerr << "fovea-bench: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
