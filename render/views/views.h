// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/view.h"

namespace loopscope {

// One function for each kind of view, called by BuildScene.

Scene BuildMapView(DerivedCache* cache, const ViewRequest& request, int oversampling);
Scene BuildSubmapView(const Recording& recording, const ViewRequest& request, int oversampling);
Scene BuildUpdateView(const Recording& recording, const ViewRequest& request, int oversampling);
Scene BuildMatchView(const Recording& recording, const ViewRequest& request, int oversampling);
Scene BuildSearchView(DerivedCache* cache, const ViewRequest& request, int oversampling);
Scene BuildGraphView(DerivedCache* cache, const ViewRequest& request, int oversampling);
Scene BuildTimeView(DerivedCache* cache, const ViewRequest& request, int oversampling);
Scene BuildChartView(const Recording& recording, const ViewRequest& request, int oversampling);

}  // namespace loopscope
