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
#include "tests/benchmark/side_by_side/summary.h"
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

// "-" where there is none.
std::string Text(const std::optional<double>& value, int decimals) {
  return value ? fmt::sprintf("%.*f", decimals, *value) : "-";
}

nlohmann::json Json(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

void PrintRow(const std::string& name, const BenchFigures& figures, std::size_t num_failed) {
  std::cout << fmt::sprintf(
      "  %-16s %7s %8s %8s %8s %8s %8s %8s %8s %8s", name, Text(figures.ratio, 2),
      Text(figures.median_ms, 1), Text(figures.p95_ms, 1), Text(figures.p99_ms, 1),
      Text(figures.most_ms, 1), Text(figures.ns_per_pixel, 0), Text(figures.ms_per_object, 1),
      Text(figures.allocations, 0), Text(figures.peak_mb, 1));
  if (num_failed > 0) std::cout << fmt::sprintf("  refuses %d frames", num_failed);
  std::cout << '\n';
}

nlohmann::json RowOf(const BenchFigures& figures, const Measurement& own) {
  nlohmann::json row = {{"ratio", Json(figures.ratio)},
                        {"median_ms", Json(figures.median_ms)},
                        {"p95_ms", Json(figures.p95_ms)},
                        {"p99_ms", Json(figures.p99_ms)},
                        {"most_ms", Json(figures.most_ms)},
                        {"ns_per_pixel", Json(figures.ns_per_pixel)},
                        {"ms_per_object", Json(figures.ms_per_object)},
                        {"allocations", Json(figures.allocations)},
                        {"peak_mb", Json(figures.peak_mb)},
                        {"refused", own.num_failed}};
  for (const std::string& stage : own.stages) {
    row["stages"][stage] = Quantile(own.stage_ms.at(stage), 0.5);
  }
  return row;
}

nlohmann::json Report(const FrameSet& set, const std::vector<Method>& methods,
                      const std::vector<Measurement>& measured, std::size_t reference) {
  nlohmann::json json;
  std::cout << fmt::sprintf("\n%s: %d frames, %s\n", set.name, set.frames.size(), set.source);
  std::cout << fmt::sprintf("  %-16s %7s %8s %8s %8s %8s %8s %8s %8s %8s\n", "", "ratio", "median",
                            "p95", "p99", "most", "ns/pixel", "ms/obj.", "allocs", "MB");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const BenchFigures figures = FiguresOf(set, measured[m], measured[reference]);
    PrintRow(methods[m].name, figures, measured[m].num_failed);
    json[methods[m].name] = RowOf(figures, measured[m]);
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
