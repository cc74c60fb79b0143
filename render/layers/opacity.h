// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkProp.h>

namespace loopscope {

/// Makes a layer clearer: its opacity becomes `share` in [0, 1] of what it was, whether it is
/// shapes, an image or labels.
void MultiplyOpacity(double share, vtkProp* layer);

}  // namespace loopscope
