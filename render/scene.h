// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>
#include <vtkProp.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>

#include "render/box.h"
#include "render/palette.h"
#include "render/view_kinds.h"

namespace loopscope {

/// A rectangle of a map [m].
using Extent = Eigen::AlignedBox2d;

/// Looks straight down: x to the right, y up.
struct FlatCamera {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< [m] in the middle of the panel
  double meters_per_pixel = 0.01;
};

/// Looks at the map from the side, in parallel rays.
struct SideView {
  double azimuth = 0.0;           ///< [rad] from which side: 0 from -y, a quarter turn from +x
  double elevation = 0.5 * M_PI;  ///< [rad] from straight from the side, 0, to straight down

  /// Its rows: what is to the right in the picture, what is up, and what comes towards the eye. A
  /// camera's center is in the coordinates of the first two.
  Eigen::Matrix3d ViewFromMap() const;
};

/// The camera that shows all of `extent` in `frame` with a small margin. What is empty or a point
/// is shown with a metre around it.
FlatCamera CameraFor(const Extent& extent, const Box& frame);

/// What the camera sees in `frame`.
Extent VisibleExtent(const FlatCamera& camera, const Box& frame);

using Props = std::vector<vtkSmartPointer<vtkProp>>;

/// A part of a panel.
struct LayerProp {
  /// Where drawing takes long, a cheaper stand-in is drawn while the camera moves.
  enum class When { kAlways, kAtRest, kMoving };

  vtkSmartPointer<vtkProp> prop;
  LayerKind kind = LayerKind::kGrid;
  When when = When::kAlways;
};

/// A map with its own camera. It is drawn from the bottom to the top: `props` in their order, then
/// texts.
struct Panel {
  Box frame;  ///< [px] of the picture
  FlatCamera camera;
  Color canvas;  ///< where nothing is drawn; if clear, what is beneath the panel is seen there
  std::vector<LayerProp> props;
  bool is_map = true;  ///< its coordinates are metres of a map; false for a chart or from the side
  std::optional<SideView> side = std::nullopt;  ///< straight down without it
  /// What stands around the panel while it is seen by a camera, in pixels of the picture: its
  /// outline, and beneath the scale bar of a map and the caption. May be empty.
  std::function<Props(const FlatCamera&)> edge = nullptr;
};

/// A picture before it is drawn: what VTK needs and nothing of how it came about.
struct Scene {
  int width = 0;         ///< [px]
  int height = 0;        ///< [px]
  int oversampling = 1;  ///< 1 or 2 pixels of the scene for one of the picture, each way
  Color paper;
  Props annotation;  ///< in pixels; without the edges of the panels
  std::vector<Panel> panels;
};

/// Makes `renderer` show what the camera sees in a panel of `height` pixels.
void LookDown(const FlatCamera& camera, double height, vtkRenderer* renderer);

/// Makes `renderer` show what the camera of `panel` sees, from above or from its side.
void PlaceCamera(const Panel& panel, vtkRenderer* renderer);

/// The whole picture as the panel beneath the others: its paper and its annotation, in pixels.
Panel SheetOf(const Scene& scene);

/// Shows those parts of a panel that are drawn while its camera moves, or while it is at rest.
void SetMoving(const Panel& panel, bool moving);

/// Fills `renderer` with a panel at rest, its camera included.
void FillRenderer(const Panel& panel, vtkRenderer* renderer);

/// Takes out of `window` what it shows.
void Clear(vtkRenderWindow* window);

/// Fills `window` with the scene, in place of what it showed. The window should have the size of
/// the scene.
void Show(const Scene& scene, vtkRenderWindow* window);

}  // namespace loopscope
