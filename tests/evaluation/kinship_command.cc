#include "tests/evaluation/kinship_command.h"

#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tests/evaluation/kinship_samples.h"
#include "tests/evaluation/logistic_regression.h"
#include "tests/evaluation/output.h"
#include "tests/evaluation/parallel.h"
#include "tests/evaluation/settings.h"

namespace fovea::evaluation {
namespace {

constexpr std::size_t kNumFolds = 5;

struct KinshipFlags {
  std::vector<std::string> plain;  // DIR or DIR=WEIGHT
  std::vector<std::string> mosd;
  std::vector<double> intrinsics = {525, 525, 319.5, 239.5};
  int num_threads = 1;
  std::string csv;
};

// The samples of all folders, one a row.
struct Rows {
  std::vector<KinshipTerms> terms;
  std::vector<double> log_odds;  // by the weights that the detector has
  std::vector<double> is_true;
  std::vector<double> weights;
  std::vector<std::size_t> folds;  // by scene
};

void AddFolder(const std::string& text, LabelEncoding encoding, const KinshipFlags& flags,
               Rows& rows) {
  const auto [folder, folder_weight] = ParseWeighted(text);
  const std::vector<std::string> names = SceneNames(folder);
  const std::vector<double>& k = flags.intrinsics;
  std::vector<std::vector<KinshipSample>> samples(names.size());
  std::mutex mutex;  // guards done
  std::size_t done = 0;
  ForEachIndex(names.size(), flags.num_threads, [&, &dir = folder](std::size_t i) {
    const Scene scene = LoadScene(dir, names[i], encoding, {k[0], k[1], k[2], k[3]});
    samples[i] = SampleKinship(scene, OptionsOfProfile("default"));
    const std::scoped_lock lock(mutex);
    ShowProgress(dir, ++done, names.size());
  });
  double total = 0;
  for (const auto& of_scene : samples) {
    for (const KinshipSample& sample : of_scene) total += sample.weight;
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (const KinshipSample& sample : samples[i]) {
      rows.terms.push_back(TermsOf(sample.kinship));
      rows.log_odds.push_back(LogOdds(sample.kinship));
      rows.is_true.push_back(sample.one_object ? 1 : 0);
      rows.weights.push_back(folder_weight * sample.weight / total);
      rows.folds.push_back(i * kNumFolds / samples.size());
    }
  }
}

struct Problem {
  Eigen::MatrixXd x;
  Eigen::VectorXd is_true;
  Eigen::VectorXd weights;
};

// The rows whose fold is `fold`, or all others.
Problem Select(const Rows& rows, std::size_t fold, bool equal) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < rows.folds.size(); ++i) {
    if ((rows.folds[i] == fold) == equal) chosen.push_back(i);
  }
  const auto size = static_cast<Eigen::Index>(chosen.size());
  Problem problem{{size, kNumKinshipTerms}, Eigen::VectorXd(size), Eigen::VectorXd(size)};
  for (Eigen::Index r = 0; r < size; ++r) {
    const std::size_t i = chosen[static_cast<std::size_t>(r)];
    problem.x.row(r) = Eigen::Map<const Eigen::RowVectorXd>(rows.terms[i].data(), kNumKinshipTerms);
    problem.is_true[r] = rows.is_true[i];
    problem.weights[r] = rows.weights[i];
  }
  return problem;
}

double CrossValidatedLoss(const Rows& rows) {
  double sum = 0, weight = 0;
  for (std::size_t fold = 0; fold < kNumFolds; ++fold) {
    const Problem train = Select(rows, fold, false), test = Select(rows, fold, true);
    if (train.x.rows() == 0 || test.x.rows() == 0) continue;
    const LogisticModel model = FitLogistic(train.x, train.is_true, train.weights);
    sum += test.weights.sum() * LogLoss(model.LogOdds(test.x), test.is_true, test.weights);
    weight += test.weights.sum();
  }
  return sum / weight;
}

std::string ToCsv(const Rows& rows) {
  std::string csv = "one_object,weight,fold";
  for (const std::string_view name : KinshipTermNames()) csv += fmt::format(",{}", name);
  for (std::size_t i = 0; i < rows.terms.size(); ++i) {
    csv += fmt::format("\n{},{:.6g},{}", rows.is_true[i], rows.weights[i], rows.folds[i]);
    for (const double term : rows.terms[i]) csv += fmt::format(",{:.6g}", term);
  }
  return csv;
}

void Run(const KinshipFlags& flags) {
  Rows rows;
  for (const std::string& folder : flags.plain) {
    AddFolder(folder, LabelEncoding::kPlain, flags, rows);
  }
  for (const std::string& folder : flags.mosd) AddFolder(folder, LabelEncoding::kMosd, flags, rows);
  if (rows.terms.empty()) throw std::runtime_error("no two segments touch in these scenes");
  WriteText(flags.csv, ToCsv(rows));
  const Problem all = Select(rows, kNumFolds, false);
  const LogisticModel model = FitLogistic(all.x, all.is_true, all.weights);
  const Eigen::VectorXd current = Eigen::Map<const Eigen::VectorXd>(
      rows.log_odds.data(), static_cast<Eigen::Index>(rows.log_odds.size()));
  fmt::print("{} pairs of segments, {:.0f} % of one object\n", rows.terms.size(),
             100 * all.is_true.mean());
  fmt::print(
      "log loss: {:.4f} with the detector's weights, {:.4f} fitted, {:.4f} on scenes left "
      "out of the fit ({} groups)\n",
      LogLoss(current, all.is_true, all.weights),
      LogLoss(model.LogOdds(all.x), all.is_true, all.weights), CrossValidatedLoss(rows), kNumFolds);
  fmt::print("{:<20} {:>10.4g}\n", "bias", model.bias);
  for (std::size_t i = 0; i < kNumKinshipTerms; ++i) {
    fmt::print("{:<20} {:>10.4g}\n", KinshipTermNames()[i],
               model.weights[static_cast<Eigen::Index>(i)]);
  }
}

}  // namespace

void AddKinshipCommand(CLI::App& app) {
  auto flags = std::make_shared<KinshipFlags>();
  CLI::App* command =
      app.add_subcommand("kinship", "Fit the weights by which segments are joined, and print them");
  auto* data = command->add_option_group("scenes");
  data->add_option(
      "--data", flags->plain,
      "Folder of <name>_{color,depth,label}.png with label = object; DIR=WEIGHT weighs "
      "it; repeatable");
  data->add_option("--mosd", flags->mosd, "The same with labels of mOSD");
  data->require_option(1, 0);
  command->add_option("--intrinsics", flags->intrinsics, "FX,FY,CX,CY of the frames in pixels")
      ->delimiter(',')
      ->expected(4)
      ->capture_default_str();
  command->add_option("--threads", flags->num_threads, "Scenes at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--csv", flags->csv, "Write all pairs to this file")->check(WhyNotWritable);
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
