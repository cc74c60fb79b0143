// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/map_image.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loopscope {
namespace {

bool AreSame(const PlacedGrid& a, const PlacedGrid& b) {
  return a.grid == b.grid && a.map_from_grid == b.map_from_grid;
}

bool AreSame(const MapColors& a, const MapColors& b) {
  return a.free == b.free && a.occupied == b.occupied && a.unknown == b.unknown;
}

}  // namespace

/// The last image, and what it takes to make the next one of it.
class MapMemory {
 public:
  MapMemory(const Raster& raster, const MapColors& colors) : colors_(colors), still_(raster) {}

  bool HoldsFor(const std::vector<PlacedGrid>& grids, const Raster& raster,
                const MapColors& colors) const {
    const auto same = [](const PlacedGrid& a, const PlacedGrid& b) { return AreSame(a, b); };
    return still_.raster() == raster && AreSame(colors_, colors) &&
           still_grids_.size() <= grids.size() &&
           std::equal(still_grids_.begin(), still_grids_.end(), grids.begin(), same);
  }

  /// HoldsFor(grids) must be true.
  std::shared_ptr<const CellImage> Compose(const std::vector<PlacedGrid>& grids) {
    constexpr std::size_t kMaxGrowing = 2;  // submaps into which scans are inserted
    const PlacedGrid* const end = grids.data() + grids.size();
    const PlacedGrid* const growing =
        grids.data() +
        std::max(still_grids_.size(), grids.size() - std::min(grids.size(), kMaxGrowing));
    const PlacedGrid* const added = grids.data() + still_grids_.size();
    const CellBox changed = Union(growing_box_, PixelsOf(added, growing, still_.raster()));
    still_.Add(added, growing);
    still_grids_.assign(grids.data(), growing);
    growing_box_ = PixelsOf(growing, end, still_.raster());
    Repaint(changed);
    LogOddsSum all = still_.PartOf(growing_box_);
    all.Add(growing, end);
    all.Paint(growing_box_, colors_, image_.get());
    return image_;
  }

 private:
  /// Shows the sums of the grids that are still, in `changed` or, if the image is too small or
  /// somebody has it, in a new one.
  void Repaint(const CellBox& changed) {
    CellBox box = Union(still_.known_box(), growing_box_);
    if (image_) box = Union(box, image_->box());
    const bool fits = image_ && image_->box() == box;
    if (fits && image_.use_count() == 1 && !image_->IsShown()) {
      still_.Paint(changed, colors_, image_.get());
    } else {
      image_ = std::make_shared<CellImage>(box);
      still_.Paint(still_.known_box(), colors_, image_.get());
    }
  }

  MapColors colors_;
  std::vector<PlacedGrid> still_grids_;
  LogOddsSum still_;     // of these
  CellBox growing_box_;  // holds what the others change in the image
  std::shared_ptr<CellImage> image_;
};

Raster RasterFor(const FlatCamera& camera, const Box& frame, double resolution) {
  Raster raster;
  raster.pixel_size = std::max(camera.meters_per_pixel, 0.5 * resolution);
  const Eigen::Vector2d size = camera.meters_per_pixel * Eigen::Vector2d(frame.width, frame.height);
  raster.width = static_cast<int>(std::ceil(size.x() / raster.pixel_size - 1e-6));
  raster.height = static_cast<int>(std::ceil(size.y() / raster.pixel_size - 1e-6));
  const double half = 0.5 * raster.pixel_size;
  raster.origin = camera.center - 0.5 * size + Eigen::Vector2d(half, half);
  return raster;
}

MapComposer::MapComposer() = default;

MapComposer::~MapComposer() = default;

std::shared_ptr<const CellImage> MapComposer::Compose(const std::vector<PlacedGrid>& grids,
                                                      const Raster& raster,
                                                      const MapColors& colors) {
  if (!composed_) {
    composed_ = true;
    return std::make_shared<CellImage>(LogOddsSum::PaintAll(grids, raster, colors));
  }
  if (!memory_ || !memory_->HoldsFor(grids, raster, colors)) {
    memory_ = std::make_unique<MapMemory>(raster, colors);
  }
  return memory_->Compose(grids);
}

vtkSmartPointer<vtkActor> MapLayer(const std::vector<PlacedGrid>& grids, const Raster& raster,
                                   const MapColors& colors, MapComposer* composer) {
  return CellImageLayer(*composer->Compose(grids, raster, colors), Pose2(raster.origin, 0.0),
                        raster.pixel_size);
}

}  // namespace loopscope
