// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "core/evaluation/relations.h"
#include "core/io/relations_file.h"
#include "core/io/tum_file.h"
#include "tests/support/datasets.h"

namespace loopscope {
namespace {

/// What Cartographer's own evaluation says of a trajectory of its own.
struct Figures {
  const char* log;
  const char* options;
  double translation;            ///< mean [m], as far as it was printed
  double translation_precision;  ///< [m]
  double rotation;               ///< mean [deg], likewise
  double rotation_precision;     ///< [deg]
};

void PrintTo(const Figures& figures, std::ostream* stream) {
  *stream << figures.log << ", " << figures.options;
}

class CartographerFigures : public testing::TestWithParam<Figures> {};

TEST_P(CartographerFigures, AreThoseOfTheRelations) {
  const Figures& expected = GetParam();
  const std::filesystem::path data = DatasetsFolder();
  const auto relations = data / "carmen" / (std::string(expected.log) + ".relations");
  const auto trajectory =
      data / "../reference" /
      (std::string(expected.log) + ".cartographer-" + expected.options + ".dense.tum");
  for (const auto& path : {relations, trajectory}) {
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  }
  const RelationsError error =
      EvaluateRelations(ReadRelations(relations.string()), ReadTum(trajectory.string()));
  EXPECT_NEAR(error.translation.mean, expected.translation, expected.translation_precision);
  EXPECT_NEAR(RadiansToDegrees(error.rotation.mean), expected.rotation,
              expected.rotation_precision);
}

INSTANTIATE_TEST_SUITE_P(Logs, CartographerFigures,
                         testing::Values(Figures{"mit-csail", "tuned", 0.0555, 5e-5, 0.55, 5e-3},
                                         Figures{"mit-csail", "default", 1.524, 5e-4, 4.00, 5e-3},
                                         Figures{"intel", "tuned", 0.0480, 5e-5, 0.57, 5e-3},
                                         Figures{"intel", "default", 6.41, 5e-3, 38.7, 5e-2}));

}  // namespace
}  // namespace loopscope
