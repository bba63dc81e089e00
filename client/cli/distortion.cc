#include "client/cli/distortion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "client/cli/parsing.h"
#include "client/images.h"

namespace fovea::cli {
namespace {

constexpr const char* kPlumbBob = "plumb_bob";
constexpr const char* kRational = "rational_polynomial";
constexpr const char* kEquidistant = "equidistant";
constexpr std::size_t kMostOfPlumbBob = 5, kMostOfAll = 8;

bool IsZero(double value) { return value == 0; }

}  // namespace

std::optional<v1::LensDistortion> MakeDistortion(const std::string& model,
                                                 std::vector<double> coefficients) {
  const bool fisheye = model == kEquidistant;
  const bool all_zero = std::all_of(coefficients.begin(), coefficients.end(), IsZero);
  if (coefficients.empty() || (all_zero && !fisheye)) return std::nullopt;
  if (!std::all_of(coefficients.begin(), coefficients.end(),
                   [](double value) { return std::isfinite(value); })) {
    throw std::invalid_argument("distortion coefficients must be finite");
  }
  if (coefficients.size() > kMostOfAll) {  // thin prisms and tilts
    if (!std::all_of(coefficients.begin() + kMostOfAll, coefficients.end(), IsZero)) {
      throw std::invalid_argument(
          "of distortion only the first 8 coefficients may be other than 0");
    }
    coefficients.resize(kMostOfAll);
  }
  return client::MakeLensDistortion(model.empty() ? kPlumbBob : model, coefficients);
}

std::optional<v1::LensDistortion> ParseDistortion(const std::string& text) {
  if (text == "none") return std::nullopt;
  const std::size_t equals = text.find('=');
  const std::string form = "MODEL=K1,K2,… or none";
  if (equals == std::string::npos || equals == 0) {
    throw std::invalid_argument("--distortion: \"" + text + "\" is not " + form);
  }
  const std::string numbers = text.substr(equals + 1);
  const auto count = static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), ',')) + 1;
  const std::vector<double> values = ParseNumbers(numbers, count, "--distortion", form);
  try {
    return MakeDistortion(text.substr(0, equals), values);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("--distortion: " + std::string(error.what()));
  }
}

std::string ModelName(const v1::LensDistortion& distortion) {
  if (distortion.model() == v1::DISTORTION_MODEL_KANNALA_BRANDT) return kEquidistant;
  const auto count = static_cast<std::size_t>(distortion.coefficients_size());
  return count > kMostOfPlumbBob ? kRational : kPlumbBob;
}

}  // namespace fovea::cli
