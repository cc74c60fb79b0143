// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/bicubic_grid.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

// Highway compiles the functions between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each
// instruction set, and chooses when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/bicubic_grid.cc"
#include <hwy/foreach_target.h>
// Must come after it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace loopscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Of four neighbours -1, 0, 1, 2: their weights at t in [0, 1) between 0 and 1, or the first or
/// second derivatives of these.
template <typename Numbers>
struct Weights {
  hn::Vec<Numbers> of[4];
};

template <typename Numbers>
HWY_INLINE Weights<Numbers> CubicWeights(Numbers numbers, hn::Vec<Numbers> t) {
  const auto c = [numbers](double value) HWY_ATTR { return hn::Set(numbers, value); };
  const auto half_t = hn::Mul(c(0.5), t);
  const auto half_t2 = hn::Mul(half_t, t);
  return {hn::Mul(half_t, hn::Sub(hn::Mul(t, hn::Sub(c(2.0), t)), c(1.0))),
          hn::Add(c(1.0), hn::Mul(half_t2, hn::Sub(hn::Mul(c(3.0), t), c(5.0)))),
          hn::Mul(half_t, hn::Add(c(1.0), hn::Mul(t, hn::Sub(c(4.0), hn::Mul(c(3.0), t))))),
          hn::Mul(half_t2, hn::Sub(t, c(1.0)))};
}

template <typename Numbers>
HWY_INLINE Weights<Numbers> CubicSlopes(Numbers numbers, hn::Vec<Numbers> t) {
  const auto c = [numbers](double value) HWY_ATTR { return hn::Set(numbers, value); };
  const auto half_t = hn::Mul(c(0.5), t);
  return {hn::Sub(hn::Mul(half_t, hn::Sub(c(4.0), hn::Mul(c(3.0), t))), c(0.5)),
          hn::Mul(half_t, hn::Sub(hn::Mul(c(9.0), t), c(10.0))),
          hn::Add(c(0.5), hn::Mul(half_t, hn::Sub(c(8.0), hn::Mul(c(9.0), t)))),
          hn::Mul(half_t, hn::Sub(hn::Mul(c(3.0), t), c(2.0)))};
}

template <typename Numbers>
HWY_INLINE Weights<Numbers> CubicCurvatures(Numbers numbers, hn::Vec<Numbers> t) {
  const auto c = [numbers](double value) HWY_ATTR { return hn::Set(numbers, value); };
  const auto three_t = hn::Mul(c(3.0), t);
  const auto nine_t = hn::Mul(c(9.0), t);
  return {hn::Sub(c(2.0), three_t), hn::Sub(nine_t, c(5.0)), hn::Sub(c(4.0), nine_t),
          hn::Sub(three_t, c(1.0))};
}

template <typename Numbers>
HWY_INLINE hn::Vec<Numbers> Weighted(const hn::Vec<Numbers> (&values)[4],
                                     const Weights<Numbers>& weights) {
  return hn::Add(hn::Add(hn::Mul(values[0], weights.of[0]), hn::Mul(values[1], weights.of[1])),
                 hn::Add(hn::Mul(values[2], weights.of[2]), hn::Mul(values[3], weights.of[3])));
}

/// Four cells side by side in each lane, 16 bits each, so many bytes after `cells`.
template <typename Rows>
HWY_INLINE hn::Vec<Rows> GatherRows(Rows rows, const CellValue* cells, hn::Vec<Rows> place) {
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
  return hn::GatherOffset(rows, reinterpret_cast<const std::int64_t*>(cells), place);
#else
  HWY_ALIGN std::int64_t gathered[hn::MaxLanes(rows)];
  hn::Store(place, rows, gathered);
  for (std::size_t i = 0; i < hn::Lanes(rows); ++i) {
    std::memcpy(&gathered[i], reinterpret_cast<const char*>(cells) + gathered[i],
                sizeof(std::int64_t));
  }
  return hn::Load(rows, gathered);
#endif
}

/// As many places as vectors of `numbers` have lanes, each at (t_x, t_y) in [0, 1) from the second
/// of four cells in the second of four rows, the first of which is so many bytes after `cells`.
/// Rows are `row_size` bytes apart. The places are points `first` and those behind it.
template <typename Numbers>
HWY_INLINE void Interpolate(Numbers numbers, const CellValue* cells,
                            hn::Vec<hn::RebindToSigned<Numbers>> place, int row_size,
                            hn::Vec<Numbers> t_x, hn::Vec<Numbers> t_y, double resolution,
                            std::size_t first, SmoothValues* found) {
  const hn::RebindToSigned<Numbers> rows;
  // Unknown cells, which are 0, count as those with the least probability, which are 1.
  const auto one = hn::Set(numbers, 1.0);
  const auto to_number = [&](auto cell) HWY_ATTR {
    // The bits of 2^52 with a small integer in the last places are those of their sum.
    constexpr double kTwoTo52 = 4503599627370496.0;
    const auto big = hn::Set(numbers, kTwoTo52);
    const auto bits = hn::Or(hn::And(cell, hn::Set(rows, 0xffff)), hn::BitCast(rows, big));
    return hn::Max(hn::Sub(hn::BitCast(numbers, bits), big), one);
  };
  const Weights<Numbers> weights_x = CubicWeights(numbers, t_x);
  const Weights<Numbers> slopes_x = CubicSlopes(numbers, t_x);
  const Weights<Numbers> curvatures_x = CubicCurvatures(numbers, t_x);
  hn::Vec<Numbers> values[4];
  hn::Vec<Numbers> slopes[4];
  hn::Vec<Numbers> curvatures[4];
  for (int i = 0; i < 4; ++i) {
    const auto row = GatherRows(rows, cells, place);
    const hn::Vec<Numbers> of_row[4] = {to_number(row), to_number(hn::ShiftRight<16>(row)),
                                        to_number(hn::ShiftRight<32>(row)),
                                        to_number(hn::ShiftRight<48>(row))};
    values[i] = Weighted<Numbers>(of_row, weights_x);
    slopes[i] = Weighted<Numbers>(of_row, slopes_x);
    curvatures[i] = Weighted<Numbers>(of_row, curvatures_x);
    place = hn::Add(place, hn::Set(rows, row_size));
  }
  const Weights<Numbers> weights_y = CubicWeights(numbers, t_y);
  const auto steps = hn::Sub(Weighted<Numbers>(values, weights_y), one);
  hn::StoreU(hn::Add(hn::Set(numbers, kMinProbability),
                     hn::Mul(hn::Set(numbers, kProbabilityStep), steps)),
             numbers, &found->values[first]);
  const auto store = [&](double scale, const hn::Vec<Numbers>(&of_rows)[4],
                         const Weights<Numbers>& weights, std::vector<double>* to) HWY_ATTR {
    hn::StoreU(hn::Mul(hn::Set(numbers, scale), Weighted<Numbers>(of_rows, weights)), numbers,
               &(*to)[first]);
  };
  const Weights<Numbers> slopes_y = CubicSlopes(numbers, t_y);
  const double per_meter = kProbabilityStep / resolution;
  store(per_meter, slopes, weights_y, &found->slopes_x);
  store(per_meter, values, slopes_y, &found->slopes_y);
  const double per_square_meter = per_meter / resolution;
  store(per_square_meter, curvatures, weights_y, &found->curvatures_xx);
  store(per_square_meter, slopes, slopes_y, &found->curvatures_xy);
  store(per_square_meter, values, CubicCurvatures(numbers, t_y), &found->curvatures_yy);
}

/// At point `index` alone, whose neighbours the grid need not hold.
void InterpolateOne(const ProbabilityGrid& grid, const PointCloud& points, std::size_t index,
                    SmoothValues* found) {
  const hn::CappedTag<double, 1> number;
  const hn::RebindToSigned<decltype(number)> rows;
  const double u = points[index].x() / grid.resolution();
  const double v = points[index].y() / grid.resolution();
  const int x = FloorToInt(u);
  const int y = FloorToInt(v);
  CellValue cells[16];
  for (int i = 0; i < 16; ++i) cells[i] = grid.value({x - 1 + i % 4, y - 1 + i / 4});
  Interpolate(number, cells, hn::Zero(rows), 4 * sizeof(CellValue), hn::Set(number, u - x),
              hn::Set(number, v - y), grid.resolution(), index, found);
}

void InterpolateHere(const ProbabilityGrid& grid, const PointCloud& points, SmoothValues* found) {
  std::size_t i = 0;
#if HWY_TARGET != HWY_SCALAR
  const hn::ScalableTag<double> numbers;
  const hn::Rebind<std::int32_t, decltype(numbers)> ints;
  const auto resolution = hn::Set(numbers, grid.resolution());
  const CellBox& box = grid.box();
  const std::size_t num_lanes = hn::Lanes(numbers);
  for (; i + num_lanes <= points.size(); i += num_lanes) {
    hn::Vec<decltype(numbers)> x;
    hn::Vec<decltype(numbers)> y;
    hn::LoadInterleaved2(numbers, points[i].data(), x, y);
    const auto u = hn::Div(x, resolution);
    const auto v = hn::Div(y, resolution);
    const auto floor_u = hn::Floor(u);
    const auto floor_v = hn::Floor(v);
    const auto column = hn::Sub(hn::DemoteTo(ints, floor_u), hn::Set(ints, box.min.x + 1));
    const auto row = hn::Sub(hn::DemoteTo(ints, floor_v), hn::Set(ints, box.min.y + 1));
    const auto before = hn::Set(ints, -1);
    const auto is_inside = hn::And(hn::And(hn::Gt(column, before), hn::Gt(row, before)),
                                   hn::And(hn::Lt(column, hn::Set(ints, box.width - 3)),
                                           hn::Lt(row, hn::Set(ints, box.height - 3))));
    if (!hn::AllFalse(ints, is_inside)) {
      const auto place = hn::ShiftLeft<1>(hn::Add(hn::Mul(row, hn::Set(ints, box.width)), column));
      static_assert(sizeof(CellValue) == 2);
      // What is not inside is read at the first cell, and then replaced.
      Interpolate(numbers, grid.cells().data(),
                  hn::PromoteTo(hn::RebindToSigned<decltype(numbers)>(),
                                hn::IfThenElseZero(is_inside, place)),
                  box.width * int{sizeof(CellValue)}, hn::Sub(u, floor_u), hn::Sub(v, floor_v),
                  grid.resolution(), i, found);
    }
    std::uint8_t inside_bits[8] = {};  // StoreMaskBits writes whole bytes
    hn::StoreMaskBits(ints, is_inside, inside_bits);
    for (std::size_t k = 0; k < num_lanes; ++k) {
      const bool lane_is_inside = ((inside_bits[k / 8] >> (k % 8)) & 1) != 0;
      if (!lane_is_inside) InterpolateOne(grid, points, i + k, found);
    }
  }
#endif
  for (; i < points.size(); ++i) InterpolateOne(grid, points, i, found);
}

}  // namespace loopscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loopscope {

HWY_EXPORT(InterpolateHere);

SmoothValues BicubicGrid::At(const PointCloud& points) const {
  SmoothValues found;
  for (std::vector<double>* const numbers :
       {&found.values, &found.slopes_x, &found.slopes_y, &found.curvatures_xx, &found.curvatures_xy,
        &found.curvatures_yy}) {
    numbers->resize(points.size());
  }
  HWY_DYNAMIC_DISPATCH(InterpolateHere)(grid_, points, &found);
  return found;
}

}  // namespace loopscope
#endif
