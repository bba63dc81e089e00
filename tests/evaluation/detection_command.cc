#include "tests/evaluation/detection_command.h"

#include <memory>

#include "core/options.h"
#include "tests/evaluation/camera_effects.h"
#include "tests/evaluation/detection_modes.h"
#include "tests/evaluation/detection_run.h"
#include "tests/evaluation/output.h"

namespace fovea::evaluation {
namespace {

std::string EffectTexts() {
  std::string texts;
  for (const CameraEffect& effect : CameraEffects()) {
    texts += "\n" + effect.name + ": " + effect.description;
  }
  return texts;
}

}  // namespace

void AddDetectionCommand(CLI::App& app) {
  auto flags = std::make_shared<DetectionFlags>();
  CLI::App* command = app.add_subcommand("detection", "Score the detector on labelled scenes");
  command->add_option("--data", flags->data, "Folder of <name>_{color,depth,label}.png")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--intrinsics", flags->intrinsics, "FX,FY,CX,CY of the frames in pixels")
      ->delimiter(',')
      ->expected(4)
      ->capture_default_str();
  const std::map<std::string, LabelEncoding> encodings = {{"mosd", LabelEncoding::kMosd},
                                                          {"plain", LabelEncoding::kPlain},
                                                          {"boxes", LabelEncoding::kBoxes}};
  command
      ->add_option(
          "--labels", flags->encoding,
          "mosd: object = value / 10 from 20 on (the default); plain: object = value; boxes: "
          "boxes.json and intrinsics.txt in the folder, or in each of its folders")
      ->transform(CLI::CheckedTransformer(encodings));
  auto* profile = command->add_option("--profile", flags->profile, "Options to start from");
  profile->check(CLI::IsMember(ProfileNames()));
  command->add_option("--set", flags->settings, "name=value of a detector option; repeatable");
  auto* methods =
      command->add_option("--methods", flags->methods,
                          "A row of scores for each of these profiles and peers, side by side");
  methods->delimiter(',')->check(CLI::IsMember(DetectionMethodNames()))->excludes(profile);
  auto* sweep = command->add_option("--sweep", flags->sweeps,
                                    "name=v1,v2,… : a row of scores for each value; repeatable");
  sweep->excludes(methods);
  command
      ->add_flag("--camera-effects", flags->with_effects,
                 "A row of scores for each of these, on top of the scenes: " + EffectTexts())
      ->excludes(methods)
      ->excludes(sweep);
  command->add_flag("--true-seeds", flags->true_seeds,
                    "One seed on each true object instead of the salient positions: how far the "
                    "segmentation is from its limit; profile paper");
  command->add_option("--threads", flags->num_threads, "Scenes detected at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command
      ->add_option("--repeat", flags->num_repeats,
                   "Detect each scene so often; the shortest times count")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option(
          "--folds", flags->num_folds,
          "Groups of scenes: for the spread of box F1, and to calibrate confidence on others")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command->add_flag("--scenes", flags->print_scenes,
                    "Print a line per scene; of boxes also with --methods");
  command->add_option("--json", flags->json, "Write all scores to this file")
      ->check(WhyNotWritable);
  command
      ->add_option("--plot", flags->plot,
                   "Write an SVG: the sweeps, the methods, or how far confidence is right")
      ->check(WhyNotWritable);
  command->add_option("--overlays", flags->overlays,
                      "Write a picture per scene, and row of scores, to this folder");
  command->callback([flags] { RunDetectionMode(*flags); });
}

}  // namespace fovea::evaluation
