// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "render/scene.h"

namespace loopscope {

/// What lies lowest in a picture: the paper, the canvases of the panels, and the cell images that
/// are drawn on these first. It is painted without OpenGL, which takes 17 ns of a processor for a
/// pixel of such an image where there is no graphics card; a copy takes less than 1.
class Ground {
 public:
  /// Takes the ground out of `scene`: what is left there is to be drawn on nothing, and blended
  /// over the ground.
  explicit Ground(Scene* scene);

  /// Row `y` of the scene, the lowest being 0, as many pixels as the scene is wide: all opaque.
  void PaintRow(int y, Color* row) const;

  /// Whether row `y` is the same as the one beneath it, as most are: cells are larger than pixels.
  bool IsLikeRowBeneath(int y) const;

 private:
  /// Pixels of the scene along one axis.
  struct Range {
    int begin = 0;
    int end = 0;

    bool Contains(int pixel) const { return begin <= pixel && pixel < end; }
  };

  /// Which cells of an image the pixels of a panel show along one axis.
  struct Cells {
    Range pixels;            ///< that show a cell
    std::vector<int> cells;  ///< for each of them
  };

  struct Image {
    vtkSmartPointer<vtkImageData> image;  ///< RGBA, as CellImage has it
    Cells columns;
    Cells rows;

    void PaintRow(int y, Color* row) const;
    /// None where it has no cells.
    std::optional<int> CellRowAt(int y) const;
  };

  struct Canvas {
    Color color;
    Range columns;
    Range rows;
    std::vector<Image> images;  ///< the lowest first
  };

  static Canvas TakeCanvas(Panel* panel);
  static std::optional<Image> ImageOf(const LayerProp& layer, const Panel& panel,
                                      const Canvas& canvas);
  static Cells CellsOf(const Range& pixels, double origin, double step, int num_cells);

  int width_;
  Color paper_;
  std::vector<Canvas> canvases_;
};

}  // namespace loopscope
