#include "client/cli/realsense_intrinsics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/cli/distortion.h"

namespace fovea::cli {
namespace {

// By the numbers of rs2_distortion.
constexpr std::array kModels{"None",   "Modified Brown Conrady", "Inverse Brown Conrady",
                             "Ftheta", "Brown Conrady",          "Kannala Brandt4"};

// As it is written; empty = it is not said.
std::string ModelIn(const nlohmann::json& json) {
  for (const char* field : {"model", "distortion_model"}) {
    if (!json.contains(field)) continue;
    const nlohmann::json& model = json[field];
    if (model.is_string()) return model.get<std::string>();
    if (model.is_number_unsigned() && model.get<std::size_t>() < kModels.size()) {
      return kModels[model.get<std::size_t>()];
    }
    throw std::runtime_error(
        std::string(field) +
        " must be a name of a lens model, for example \"Brown Conrady\", or its number (0 to 5)");
  }
  return {};
}

// "<distortion.brown_conrady: 4>" and "Brown Conrady" → "brown_conrady".
std::string ShortName(std::string model) {
  model.erase(std::min(model.find_first_of(":>"), model.size()));
  model.erase(0, model.rfind('.') + 1);
  std::transform(model.begin(), model.end(), model.begin(), [](unsigned char letter) {
    return letter == ' ' ? '_' : static_cast<char>(std::tolower(letter));
  });
  return model;
}

std::vector<double> CoeffsIn(const nlohmann::json& json) {
  const nlohmann::json& coeffs = json[kCoeffs];
  const bool are_numbers =
      coeffs.is_array() && std::all_of(coeffs.begin(), coeffs.end(),
                                       [](const nlohmann::json& each) { return each.is_number(); });
  if (!are_numbers) throw std::runtime_error(std::string(kCoeffs) + " must be numbers");
  return coeffs.get<std::vector<double>>();
}

bool IsOfRos(const std::string& name) {
  return name == "plumb_bob" || name == "rational_polynomial" || name == "equidistant";
}

}  // namespace

std::optional<v1::LensDistortion> DistortionOfCoeffs(const nlohmann::json& json) {
  const std::vector<double> coeffs = CoeffsIn(json);
  const std::string model = ModelIn(json), name = ShortName(model);
  if (name == "brown_conrady") return MakeDistortion("plumb_bob", coeffs);
  if (IsOfRos(name)) return MakeDistortion(name, coeffs);
  if (name == "kannala_brandt4") {
    throw std::runtime_error("coeffs of the model \"" + model +
                             "\" are not read: give distortion_model \"equidistant\" and "
                             "distortion with the first four");
  }
  const bool are_all_zero =
      std::all_of(coeffs.begin(), coeffs.end(), [](double value) { return value == 0; });
  if (are_all_zero) return std::nullopt;
  if (model.empty()) {
    throw std::runtime_error(
        "it has coeffs and no model, for example \"Brown Conrady\", to say what they mean");
  }
  throw std::runtime_error(fmt::format(
      "coeffs of the model \"{}\" are not all 0, and only those of \"Brown Conrady\" are read: "
      "rectify the images, or give distortion_model and distortion",
      model.substr(0, 64)));
}

}  // namespace fovea::cli
