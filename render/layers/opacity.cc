// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/opacity.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkLabeledDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>

namespace loopscope {

void MultiplyOpacity(double share, vtkProp* layer) {
  if (auto* const actor = vtkActor::SafeDownCast(layer)) {
    // On top of that of each colour.
    actor->GetProperty()->SetOpacity(share * actor->GetProperty()->GetOpacity());
    return;
  }
  auto* const labels = vtkActor2D::SafeDownCast(layer);
  if (labels == nullptr) return;
  auto* const mapper = vtkLabeledDataMapper::SafeDownCast(labels->GetMapper());
  if (mapper == nullptr) return;
  vtkTextProperty* const text = mapper->GetLabelTextProperty();
  text->SetOpacity(share * text->GetOpacity());
  text->SetBackgroundOpacity(share * text->GetBackgroundOpacity());
}

}  // namespace loopscope
