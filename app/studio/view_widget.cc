// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/view_widget.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>
#include <mutex>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include "render/text.h"

namespace loopscope {
namespace {

constexpr int kRestMilliseconds = 120;
constexpr int kClickPixels = 3;  // a hand that moves less clicks

bool Contains(const Box& box, const Eigen::Vector2d& point) {
  return box.left <= point.x() && point.x() <= box.right() && box.bottom <= point.y() &&
         point.y() <= box.top();
}

}  // namespace

ViewWidget::ViewWidget(QWidget* parent) : QVTKOpenGLNativeWidget(parent) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  vtkNew<vtkRenderer> paper;
  const QColor color = palette().color(QPalette::Base);
  paper->SetBackground(color.redF(), color.greenF(), color.blueF());
  window->AddRenderer(paper);
  paper_ = paper;
  setRenderWindow(window);
  setEnableHiDPI(false);  // texts of a scene are as large already as the screen needs them
  interactor()->SetInteractorStyle(nullptr);
  setMouseTracking(true);
  setFocusPolicy(Qt::ClickFocus);
  setMinimumSize(160, 100);
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMilliseconds);
  connect(&rest_, &QTimer::timeout, this, &ViewWidget::TellRest);
}

void ViewWidget::Show(Scene scene, bool keep_camera) {
  makeCurrent();
  const bool is_moving = keep_camera && rest_.isActive() && has_scene();
  const FlatCamera moving = is_moving ? scene_.panels.front().camera : FlatCamera();
  scene_ = std::move(scene);
  // The edge of the main panel follows its camera: it is drawn here.
  draw_edge_ = std::exchange(scene_.panels.front().edge, nullptr);
  edge_.clear();
  loopscope::Show(scene_, renderWindow());
  panels_.clear();
  vtkRendererCollection* const renderers = renderWindow()->GetRenderers();
  renderers->InitTraversal();
  paper_ = renderers->GetNextItem();
  while (vtkRenderer* const renderer = renderers->GetNextItem()) panels_.push_back(renderer);
  is_moved_ = false;
  DrawEdge();
  if (is_moving) {
    MoveTo(moving);
  } else {
    Draw();
  }
}

void ViewWidget::Clear() {
  makeCurrent();
  scene_ = Scene();
  draw_edge_ = nullptr;
  edge_.clear();
  for (vtkRenderer* const panel : panels_) renderWindow()->RemoveRenderer(panel);
  panels_.clear();
  pressed_at_.reset();
  is_dragging_ = false;
  is_moved_ = false;
  rest_.stop();
  paper_->RemoveAllViewProps();
  Draw();
}

void ViewWidget::DrawEdge() {
  for (const auto& prop : edge_) paper_->RemoveViewProp(prop);
  if (draw_edge_) edge_ = draw_edge_(scene_.panels.front().camera);
  for (const auto& prop : edge_) paper_->AddViewProp(prop);
}

void ViewWidget::Draw() {
  if (!isValid()) return;  // paintGL will
  const std::lock_guard<std::mutex> lock(FontLock());
  renderWindow()->Render();
  update();
}

int ViewWidget::device_pixels() const {
  return std::max(1, static_cast<int>(std::lround(devicePixelRatioF())));
}

Eigen::Vector2d ViewWidget::ToScene(const QPoint& position) const {
  return {(position.x() + 0.5) * scene_.width / width(),
          (height() - position.y() - 0.5) * scene_.height / height()};
}

std::optional<ViewWidget::Place> ViewWidget::PlaceAt(const QPoint& position) const {
  const Eigen::Vector2d pixel = ToScene(position);
  for (std::size_t i = 0; i < scene_.panels.size(); ++i) {
    const Panel& panel = scene_.panels[i];
    if (!Contains(panel.frame, pixel)) continue;
    const Eigen::Vector2d middle(panel.frame.center_x(), panel.frame.center_y());
    const double scale = panel.camera.meters_per_pixel;
    return Place{static_cast<int>(i), panel.camera.center + scale * (pixel - middle), scale,
                 panel.is_map};
  }
  return std::nullopt;
}

bool ViewWidget::CanMove(int panel) const {
  return panel == 0 && (scene_.panels[0].is_map || scene_.panels[0].side);
}

void ViewWidget::paintGL() {
  const std::lock_guard<std::mutex> lock(FontLock());
  QVTKOpenGLNativeWidget::paintGL();
}

void ViewWidget::resizeEvent(QResizeEvent* event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  emit Resized();
}

void ViewWidget::MoveTo(const FlatCamera& camera) {
  Panel& panel = scene_.panels.front();
  panel.camera = camera;
  PlaceCamera(panel, panels_.front());
  is_moved_ = true;
  SetMoving(panel, true);
  DrawEdge();
  rest_.start();
  Draw();
}

void ViewWidget::TellRest() {
  if (!is_moved_ || scene_.panels.empty()) return;
  const Panel& panel = scene_.panels.front();
  SetMoving(panel, false);
  Draw();
  emit CameraRested(panel.camera.center.x(), panel.camera.center.y(),
                    panel.camera.meters_per_pixel * panel.frame.width);
}

void ViewWidget::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton || scene_.panels.empty()) return;
  pressed_at_ = event->pos();
  is_dragging_ = false;
  camera_when_pressed_ = scene_.panels.front().camera;
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_at_) {
    emit Hovered(event->pos());
    return;
  }
  const QPoint moved = event->pos() - *pressed_at_;
  if (!is_dragging_ && moved.manhattanLength() <= kClickPixels) return;
  const auto start = PlaceAt(*pressed_at_);
  if (!is_dragging_ && (!start || !CanMove(start->panel))) return;
  is_dragging_ = true;
  FlatCamera camera = camera_when_pressed_;
  const Eigen::Vector2d pixels = ToScene(event->pos()) - ToScene(*pressed_at_);
  camera.center -= camera.meters_per_pixel * pixels;
  MoveTo(camera);
}

void ViewWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (pressed_at_ && !is_dragging_ && event->button() == Qt::LeftButton) {
    emit Clicked(event->pos());
  }
  pressed_at_.reset();
  is_dragging_ = false;
}

void ViewWidget::mouseDoubleClickEvent(QMouseEvent* event) { emit DoubleClicked(event->pos()); }

void ViewWidget::wheelEvent(QWheelEvent* event) {
  const auto place = PlaceAt(event->position().toPoint());
  if (!place || !CanMove(place->panel)) return;
  constexpr double kZoomPerStep = 1.25;
  const double steps = event->angleDelta().y() / 120.0;
  const double factor = std::pow(kZoomPerStep, -steps);
  FlatCamera camera = scene_.panels.front().camera;
  camera.center = place->point + factor * (camera.center - place->point);
  camera.meters_per_pixel = std::clamp(camera.meters_per_pixel * factor, 1e-5, 10.0);
  MoveTo(camera);
}

void ViewWidget::leaveEvent(QEvent*) { emit Left(); }

}  // namespace loopscope
