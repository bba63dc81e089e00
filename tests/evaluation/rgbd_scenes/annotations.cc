#include "tests/evaluation/rgbd_scenes/annotations.h"

#include <fmt/format.h>
#include <matio.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace fovea::evaluation {
namespace {

struct Close {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

std::size_t CountElements(const matvar_t& variable) {
  std::size_t count = variable.rank > 0 ? 1 : 0;
  for (int i = 0; i < variable.rank; ++i) count *= variable.dims[i];
  return count;
}

template <typename T>
double First(const matvar_t& variable) {
  return static_cast<double>(*static_cast<const T*>(variable.data));
}

// NaN where it is no number.
double NumberOf(const matvar_t& variable) {
  if (variable.data == nullptr || CountElements(variable) != 1) return NAN;
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      return First<double>(variable);
    case MAT_C_SINGLE:
      return First<float>(variable);
    case MAT_C_INT32:
      return First<std::int32_t>(variable);
    case MAT_C_UINT32:
      return First<std::uint32_t>(variable);
    case MAT_C_INT16:
      return First<std::int16_t>(variable);
    case MAT_C_UINT16:
      return First<std::uint16_t>(variable);
    case MAT_C_INT8:
      return First<std::int8_t>(variable);
    case MAT_C_UINT8:
      return First<std::uint8_t>(variable);
    default:
      return NAN;
  }
}

// Empty where it is no text of one byte a character.
std::string TextOf(const matvar_t& variable) {
  if (variable.class_type != MAT_C_CHAR || variable.data == nullptr) return "";
  const std::size_t length = CountElements(variable);
  if (variable.data_size == 1) return {static_cast<const char*>(variable.data), length};
  std::string text;
  if (variable.data_size != 2) return text;
  const auto* wide = static_cast<const std::uint16_t*>(variable.data);
  for (std::size_t i = 0; i < length && wide[i] < 128; ++i) text += static_cast<char>(wide[i]);
  return text;
}

// One struct of an array, for errors by its place.
class Fields {
 public:
  Fields(matvar_t& array, std::size_t index, std::string place)
      : array_(array), index_(index), place_(std::move(place)) {}

  std::string Text(const char* name) const {
    std::string text = TextOf(Field(name));
    if (text.empty()) Fail(name, "is no text");
    return text;
  }
  int Pixel(const char* name) const {
    const double number = NumberOf(Field(name));
    if (!(number >= 1 && number <= 100000)) {
      Fail(name, fmt::format("is {}, no pixel from 1 to 100000", number));
    }
    return static_cast<int>(std::lround(number));
  }
  [[noreturn]] void Fail(const char* name, const std::string& what) const {
    throw std::runtime_error(fmt::format("{}.{} {}", place_, name, what));
  }

 private:
  const matvar_t& Field(const char* name) const {
    const matvar_t* field = Mat_VarGetStructFieldByName(&array_, name, index_);
    if (field == nullptr) Fail(name, "is missing");
    return *field;
  }

  matvar_t& array_;
  std::size_t index_;
  std::string place_;
};

AnnotatedObject ObjectOf(const Fields& fields) {
  const int left = fields.Pixel("left"), right = fields.Pixel("right");
  const int top = fields.Pixel("top"), bottom = fields.Pixel("bottom");
  if (right < left) fields.Fail("right", "is left of left");
  if (bottom < top) fields.Fail("bottom", "is above top");
  return {fields.Text("category"), {left - 1, top - 1, right - left + 1, bottom - top + 1}};
}

std::vector<AnnotatedObject> ObjectsOf(matvar_t* cell, const std::string& place) {
  std::vector<AnnotatedObject> objects;
  if (cell == nullptr || CountElements(*cell) == 0) return objects;  // nothing in this frame
  if (cell->class_type != MAT_C_STRUCT) throw std::runtime_error(place + " is no struct array");
  const std::size_t count = CountElements(*cell);
  for (std::size_t i = 0; i < count; ++i) {
    objects.push_back(ObjectOf({*cell, i, fmt::format("{}({})", place, i + 1)}));
  }
  return objects;
}

}  // namespace

std::vector<std::vector<AnnotatedObject>> ReadAnnotations(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::unique_ptr<mat_t, Close> opened(Mat_Open(name.c_str(), MAT_ACC_RDONLY));
  if (!opened) throw std::runtime_error(name + ": cannot be read as a MATLAB file");
  const std::unique_ptr<matvar_t, Close> boxes(Mat_VarRead(opened.get(), "bboxes"));
  if (!boxes) throw std::runtime_error(name + ": has no variable bboxes");
  if (boxes->class_type != MAT_C_CELL) {
    throw std::runtime_error(name + ": bboxes is no cell array");
  }
  std::vector<std::vector<AnnotatedObject>> frames;
  const std::size_t count = CountElements(*boxes);
  for (std::size_t i = 0; i < count; ++i) {
    matvar_t* cell = Mat_VarGetCell(boxes.get(), static_cast<int>(i));
    frames.push_back(ObjectsOf(cell, fmt::format("{}: bboxes{{{}}}", name, i + 1)));
  }
  return frames;
}

}  // namespace fovea::evaluation
