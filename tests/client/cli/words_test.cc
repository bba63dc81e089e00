// What the contract can say has words for people.
#include "client/cli/words.h"

#include <google/protobuf/generated_enum_reflection.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace fovea::testing {
namespace {

using cli::WordOf;

template <typename Enum>
void ExpectWordsOfTheirOwn() {
  const auto* const values = google::protobuf::GetEnumDescriptor<Enum>();
  const std::string unknown = WordOf(static_cast<Enum>(0));
  std::set<std::string> words{unknown};
  for (int i = 1; i < values->value_count(); ++i) {
    const auto value = static_cast<Enum>(values->value(i)->number());
    EXPECT_TRUE(words.insert(WordOf(value)).second) << values->value(i)->name();
  }
}

TEST(Words, DifferForWhatTheContractTellsApart) {
  ExpectWordsOfTheirOwn<v1::ShapeKind>();
  ExpectWordsOfTheirOwn<v1::GraspKind>();
  ExpectWordsOfTheirOwn<v1::NoGraspReason>();
}

}  // namespace
}  // namespace fovea::testing
