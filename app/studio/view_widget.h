// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPoint>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>
#include <functional>
#include <optional>
#include <vector>

#include "render/scene.h"

namespace loopscope {

/// Shows a scene, whose main panel can be dragged and zoomed. VTK's own keys and mouse actions do
/// not exist here.
class ViewWidget : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit ViewWidget(QWidget* parent = nullptr);

  /// With `keep_camera`, a hand that moves the camera right now is not disturbed.
  void Show(Scene scene, bool keep_camera);
  /// Shows an empty paper instead.
  void Clear();
  bool has_scene() const { return !scene_.panels.empty(); }
  /// Pixels of the screen for one of Qt's.
  int device_pixels() const;

  /// Where a point of the widget lies in a panel, if it does.
  struct Place {
    int panel = 0;
    Eigen::Vector2d point;          ///< in the panel's coordinates
    double meters_per_pixel = 0.0;  ///< of the screen
    bool is_map = true;             ///< the coordinates are metres
  };
  std::optional<Place> PlaceAt(const QPoint& position) const;

 signals:
  void Resized();
  /// The person moved the main panel, and the hand rests.
  void CameraRested(double center_x, double center_y, double width_in_meters);
  void Hovered(const QPoint& position);
  void Left();
  void Clicked(const QPoint& position);
  void DoubleClicked(const QPoint& position);

 protected:
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void Draw();
  void DrawEdge();
  void MoveTo(const FlatCamera& camera);
  void TellRest();
  /// A chart has no camera to move.
  bool CanMove(int panel) const;
  /// In pixels of the scene, from its lower left.
  Eigen::Vector2d ToScene(const QPoint& position) const;

  Scene scene_;
  std::vector<vtkRenderer*> panels_;                   // of the window, as in scene_
  vtkRenderer* paper_ = nullptr;                       // around the panels, even without them
  std::function<Props(const FlatCamera&)> draw_edge_;  // of the main panel
  Props edge_;
  bool is_moved_ = false;  // the camera is not that of the scene
  std::optional<QPoint> pressed_at_;
  bool is_dragging_ = false;
  FlatCamera camera_when_pressed_;
  QTimer rest_;
};

}  // namespace loopscope
