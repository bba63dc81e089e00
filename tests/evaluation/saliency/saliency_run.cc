#include "tests/evaluation/saliency/saliency_run.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "tests/evaluation/parallel.h"
#include "tests/evaluation/saliency/map_filters.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

cv::Mat ReadImage(const std::filesystem::path& path, const std::vector<cv::Point>& fixations) {
  cv::Mat color = cv::imread(path.string(), cv::IMREAD_COLOR);
  if (color.empty()) throw std::runtime_error(path.string() + ": cannot be read as an image");
  const cv::Rect inside({0, 0}, color.size());
  for (const cv::Point& pixel : fixations) {
    if (!inside.contains(pixel)) {
      throw std::runtime_error(path.string() + ": a fixation lies outside the image");
    }
  }
  cv::cvtColor(color, color, cv::COLOR_BGR2RGB);
  return color;
}

// The scores of one map after each blur.
class MapScorer {
 public:
  MapScorer(const FixatedImage& image, const cv::Size& size, const SaliencyRunOptions& options,
            std::uint64_t seed)
      : fixations_(image.fixations), options_(options), seed_(seed) {
    density_ = FixationDensity(fixations_, size, options.fixation_sigma * size.width);
    if (options.center_prior > 0) prior_ = CenterPrior(size, options.center_prior);
  }

  SaliencyScores Score(const cv::Mat& map, double sigma) const {
    cv::Mat filtered = Blur(map, sigma * map.cols, options_.border);
    if (!prior_.empty()) filtered = ScaleToUnit(filtered).mul(prior_);
    return {AucBorji(filtered, fixations_, seed_), Nss(filtered, fixations_),
            Correlation(filtered, density_)};
  }

 private:
  const std::vector<cv::Point>& fixations_;
  const SaliencyRunOptions& options_;
  std::uint64_t seed_;
  cv::Mat density_, prior_;
};

}  // namespace

std::vector<SaliencyResult> RunSaliency(const std::filesystem::path& folder,
                                        const std::vector<FixatedImage>& images,
                                        const std::vector<SaliencyMethod>& methods,
                                        const SaliencyRunOptions& options, const MapDone& done) {
  std::vector<SaliencyResult> results;
  for (const SaliencyMethod& method : methods) {
    results.push_back({method.name, {}, 0});
    results.back().scores.assign(options.sigmas.size(), std::vector<SaliencyScores>(images.size()));
  }
  std::vector<std::vector<double>> times(methods.size(), std::vector<double>(images.size()));
  std::mutex mutex;  // guards done

  ForEachIndex(images.size(), options.num_threads, [&](std::size_t i) {
    const cv::Mat color = ReadImage(folder / images[i].file, images[i].fixations);
    const MapScorer scorer(images[i], color.size(), options, options.seed + i);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto start = std::chrono::steady_clock::now();
      const cv::Mat map = methods[m].compute(color);
      const std::chrono::duration<double, std::milli> time =
          std::chrono::steady_clock::now() - start;
      times[m][i] = time.count();
      for (std::size_t s = 0; s < options.sigmas.size(); ++s) {
        results[m].scores[s][i] = scorer.Score(map, options.sigmas[s]);
      }
      const std::scoped_lock lock(mutex);
      if (done) done(images[i], methods[m].name, map);
    }
  });
  for (std::size_t m = 0; m < methods.size(); ++m) results[m].median_ms = Median(times[m]);
  return results;
}

}  // namespace fovea::evaluation
