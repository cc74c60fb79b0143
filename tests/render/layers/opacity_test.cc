// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/opacity.h"

#include <vtkLabeledDataMapper.h>
#include <vtkProperty.h>

#include <gtest/gtest.h>

#include "render/layers/labels.h"
#include "render/layers/shapes.h"

namespace loopscope {
namespace {

TEST(MultiplyOpacityTest, FadesShapesByAShareOfWhatTheyWere) {
  Shapes shapes;
  shapes.AddDisc({0.0, 0.0}, 1.0, Color{});
  const auto layer = MakeActor(shapes.Build());
  MultiplyOpacity(0.5, layer);
  EXPECT_DOUBLE_EQ(layer->GetProperty()->GetOpacity(), 0.5);
  MultiplyOpacity(0.5, layer);
  EXPECT_DOUBLE_EQ(layer->GetProperty()->GetOpacity(), 0.25);
}

TEST(MultiplyOpacityTest, FadesLabelsAndTheirPlates) {
  const auto layer = LabelsLayer({{{0.0, 0.0}, "text"}}, {}, WithOpacity(Color{}, 0.6));
  MultiplyOpacity(0.5, layer);
  auto* const text = vtkLabeledDataMapper::SafeDownCast(layer->GetMapper())->GetLabelTextProperty();
  EXPECT_DOUBLE_EQ(text->GetOpacity(), 0.5);
  EXPECT_NEAR(text->GetBackgroundOpacity(), 0.3, 1e-9);
}

}  // namespace
}  // namespace loopscope
