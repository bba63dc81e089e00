#include "tests/evaluation/saliency/saliency_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/evaluation/output.h"
#include "tests/evaluation/saliency/map_filters.h"
#include "tests/evaluation/saliency/saliency_report.h"
#include "tests/support/scene_files.h"

namespace fovea::evaluation {
namespace {

struct SaliencyFlags {
  std::string images;
  std::string fixations;
  std::vector<std::string> methods = SaliencyMethodNames();
  SaliencyRunOptions run;
  std::string maps;
  std::string plot;
  std::string json;
};

// The paper's: 0 to 0.16 of the image width.
std::vector<double> DefaultSigmas() {
  std::vector<double> sigmas;
  for (int percent = 0; percent <= 16; ++percent) sigmas.push_back(percent / 100.0);
  return sigmas;
}

void WriteMap(const std::string& folder, const FixatedImage& image, const std::string& method,
              const cv::Mat& map) {
  cv::Mat picture;
  ScaleToUnit(map).convertTo(picture, CV_8U, 255);
  const std::string stem = std::filesystem::path(image.file).stem().string();
  scenes::WriteImage(fmt::format("{}/{}_{}.png", folder, stem, method), picture);
}

void Run(const SaliencyFlags& flags) {
  if (!flags.maps.empty()) std::filesystem::create_directories(flags.maps);
  const std::vector<FixatedImage> images = LoadFixations(flags.fixations);
  std::vector<SaliencyMethod> methods;
  for (const std::string& name : flags.methods) methods.push_back(MakeSaliencyMethod(name));

  std::size_t done = 0;
  const std::size_t total = images.size() * methods.size();
  const auto results =
      RunSaliency(flags.images, images, methods, flags.run,
                  [&](const FixatedImage& image, const std::string& method, const cv::Mat& map) {
                    ShowProgress("maps", ++done, total);
                    if (!flags.maps.empty()) WriteMap(flags.maps, image, method, map);
                  });
  std::cout << images.size() << " images, seed " << flags.run.seed << '\n';
  PrintSaliency(std::cout, results, flags.run.sigmas);
  WriteText(flags.plot, DrawSvg(SaliencyCharts(results, flags.run.sigmas)));
  WriteJson(flags.json, ToJson(results, flags.run));
}

void AddScoring(CLI::App& command, SaliencyRunOptions& run) {
  run.sigmas = DefaultSigmas();
  command
      .add_option("--sigmas", run.sigmas,
                  "Blurs of the maps in image widths (default: 0,0.01,…,0.16)")
      ->delimiter(',')
      ->check(CLI::Range(0.0, 1.0));
  const std::map<std::string, cv::BorderTypes> borders = {{"zero", cv::BORDER_CONSTANT},
                                                          {"reflect", cv::BORDER_REFLECT}};
  command
      .add_option("--blur-border", run.border,
                  "What a blur meets beyond the map: zero (the default) or reflect")
      ->transform(CLI::CheckedTransformer(borders));
  command
      .add_option("--center-prior", run.center_prior,
                  "Multiply every map by a central Gaussian of this share of width and height")
      ->check(CLI::Range(0.0, 10.0));
  command
      .add_option("--fixation-sigma", run.fixation_sigma,
                  "Blur of the fixations for CC in image widths")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command.add_option("--seed", run.seed, "Of the random pixels of AUC-Borji")
      ->capture_default_str();
  command.add_option("--threads", run.num_threads, "Images at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
}

}  // namespace

void AddSaliencyCommand(CLI::App& app) {
  auto flags = std::make_shared<SaliencyFlags>();
  CLI::App* command = app.add_subcommand("saliency", "Score saliency maps against fixations");
  command->add_option("--images", flags->images, "Folder of the images")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--fixations", flags->fixations, "JSON: image file → list of [x, y] pixels")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("--methods", flags->methods, "Which to compare, in this order")
      ->delimiter(',')
      ->check(CLI::IsMember(SaliencyMethodNames()))
      ->capture_default_str();
  AddScoring(*command, flags->run);
  command->add_option("--maps", flags->maps, "Write every map, scaled to 0 … 255, to this folder");
  command->add_option("--plot", flags->plot, "Write the scores over the blurs to this SVG")
      ->check(WhyNotWritable);
  command->add_option("--json", flags->json, "Write all scores to this file")
      ->check(WhyNotWritable);
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
