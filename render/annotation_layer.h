// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/annotation.h"
#include "render/layout.h"
#include "render/scene.h"

namespace loopscope {

/// Title, legend, colour bars and facts in their boxes. Texts that are too long are shortened.
Props DrawAnnotation(const Annotation& annotation, const Layout& layout, const Palette& palette);

/// The outline of a panel and, beneath, a scale bar and `caption`: its first parts, as many as fit.
/// There is no scale bar without `camera`.
Props DrawPanelEdge(const PanelBoxes& boxes, const FlatCamera* camera,
                    const std::vector<std::string>& caption, const SheetSize& size,
                    const Palette& palette);

}  // namespace loopscope
