#include "tests/evaluation/rgbd_scenes/rgbd_scenes_command.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/evaluation/output.h"
#include "tests/evaluation/plot.h"
#include "tests/evaluation/rgbd_scenes/scenario.h"

namespace fovea::evaluation {
namespace {

struct RgbdScenesFlags {
  std::string data;
  std::vector<double> intrinsics = {570.3, 570.3, 320, 240};
  std::string profile = "paper";
  std::vector<double> gammas = {180};
  std::string json, plot;
};

double PercentOf(const DetectionRate& rate) {
  return rate.objects > 0 ? 100.0 * rate.detected / rate.objects : 0;
}

void PrintRow(const Scenario& scenario, double gamma, const DetectionRate& rate) {
  const PublishedRate paper = PublishedRateOf(scenario.name);
  std::cout << fmt::format("{:<20} {:>6} {:>8} {:>9.1f}", scenario.name, gamma, rate.objects,
                           PercentOf(rate));
  if (paper.objects > 0) std::cout << fmt::format(" {:>8} {:>9.1f}", paper.objects, paper.percent);
  std::cout << '\n' << std::flush;
}

void Run(const RgbdScenesFlags& flags) {
  const std::vector<double>& k = flags.intrinsics;
  Chart chart;
  chart.title = "RGB-D Scenes";
  chart.x_label = "gamma, 1/m2";
  chart.y_label = "share of annotated objects detected";
  nlohmann::json rows = nlohmann::json::array();
  std::cout << "Only some categories are annotated, so that precision cannot be told.\n"
            << fmt::format("{:<20} {:>6} {:>8} {:>9} {:>8} {:>9}\n", "", "gamma", "objects",
                           "detected%", "paper's", "detected%");
  for (const Scenario& scenario : FindScenarios(flags.data)) {
    Series series;
    series.name = scenario.name;
    for (const double gamma : flags.gammas) {
      DetectorOptions options = OptionsOfProfile(flags.profile);
      SetOption(options, "mrf.gamma_per_m2", gamma);
      std::size_t done = 0;
      const DetectionRate rate = RateOf(scenario, {k[0], k[1], k[2], k[3]}, options, [&] {
        ShowProgress(scenario.name, ++done, scenario.objects.size());
      });
      PrintRow(scenario, gamma, rate);
      rows.push_back({{"scenario", scenario.name},
                      {"gamma_per_m2", gamma},
                      {"objects", rate.objects},
                      {"detected", rate.detected}});
      series.x.push_back(gamma);
      series.y.push_back(PercentOf(rate) / 100);
    }
    chart.series.push_back(series);
  }
  WriteText(flags.plot, DrawSvg({chart}));
  WriteJson(flags.json, rows);
}

}  // namespace

void AddRgbdScenesCommand(CLI::App& app) {
  auto flags = std::make_shared<RgbdScenesFlags>();
  CLI::App* command = app.add_subcommand(
      "rgbd-scenes", "Share of annotated objects detected in RGB-D Scenes (the paper's Table 4)");
  command
      ->add_option("--data", flags->data,
                   "Folder of NAME.mat beside NAME/NAME_1.png and NAME_1_depth.png, …")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--intrinsics", flags->intrinsics, "FX,FY,CX,CY of the frames in pixels")
      ->delimiter(',')
      ->expected(4)
      ->capture_default_str();
  command->add_option("--profile", flags->profile, "Options to start from")
      ->check(CLI::IsMember(ProfileNames()))
      ->capture_default_str();
  command->add_option("--gamma", flags->gammas, "Values of mrf.gamma_per_m2 (Fig. 8a)")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--json", flags->json, "Write the counts to this file")
      ->check(WhyNotWritable);
  command->add_option("--plot", flags->plot, "Write an SVG: a line over gamma for each scenario")
      ->check(WhyNotWritable);
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
