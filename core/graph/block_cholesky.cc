// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/block_cholesky.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace loopscope {
namespace {

constexpr int kNone = -1;

/// The columns to the left that the next column needs: each waits, in a list, for the row of the
/// block that it has next.
class WaitingColumns {
 public:
  explicit WaitingColumns(int size) : first_(size, kNone), next_(size, kNone) {}

  void Wait(int column, int row) {
    next_[column] = first_[row];
    first_[row] = column;
  }
  /// Takes one of those that wait for `row`; kNone if there is none.
  int Take(int row) {
    const int column = first_[row];
    if (column != kNone) first_[row] = next_[column];
    return column;
  }

 private:
  std::vector<int> first_;  ///< by row
  std::vector<int> next_;   ///< by column
};

/// Replaces `block` by the inverse of its Cholesky factor. Whether it is positive definite.
bool InvertFactor(Eigen::Matrix3d* block) {
  const Eigen::Matrix3d a = *block;
  const double d0 = a(0, 0);
  const double l00 = std::sqrt(d0);
  const double l10 = a(1, 0) / l00;
  const double l20 = a(2, 0) / l00;
  const double d1 = a(1, 1) - l10 * l10;
  const double l11 = std::sqrt(d1);
  const double l21 = (a(2, 1) - l20 * l10) / l11;
  const double d2 = a(2, 2) - l20 * l20 - l21 * l21;
  const double l22 = std::sqrt(d2);
  if (!(d0 > 0.0 && d1 > 0.0 && d2 > 0.0 && std::isfinite(l00 + l11 + l22))) return false;
  *block << 1.0 / l00, 0.0, 0.0,           //
      -l10 / (l00 * l11), 1.0 / l11, 0.0,  //
      (l10 * l21 - l11 * l20) / (l00 * l11 * l22), -l21 / (l11 * l22), 1.0 / l22;
  return true;
}

}  // namespace

BlockCholesky::BlockCholesky(int size, const std::vector<Place>& places) : inverses_(size) {
  ChooseOrder(size, places);
  LayOutColumns(places);
  FindTargets(places);
}

void BlockCholesky::ChooseOrder(int size, const std::vector<Place>& places) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(size + places.size());
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 1.0);
  for (const Place& place : places) entries.emplace_back(place.row, place.column, 1.0);
  Eigen::SparseMatrix<double> pattern(size, size);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  const Eigen::SparseMatrix<double> both_halves = pattern.selfadjointView<Eigen::Lower>();
  Eigen::AMDOrdering<int>()(both_halves, order);
  eliminated_.assign(order.indices().data(), order.indices().data() + size);
  column_of_.resize(size);
  for (int column = 0; column < size; ++column) column_of_[eliminated_[column]] = column;
}

void BlockCholesky::LayOutColumns(const std::vector<Place>& places) {
  const int size = static_cast<int>(eliminated_.size());
  std::vector<std::vector<int>> rows_of(size);
  for (const Place& place : places) {
    assert(place.row > place.column);
    const auto [low, high] = std::minmax(column_of_[place.row], column_of_[place.column]);
    rows_of[low].push_back(high);
  }
  // A column has the rows of the matrix, and those of the columns whose first row it is.
  std::vector<std::vector<int>> children(size);
  std::vector<int> seen_in(size, kNone);
  begin_.push_back(0);
  for (int column = 0; column < size; ++column) {
    std::vector<int>& rows = rows_of[column];
    for (const int row : rows) seen_in[row] = column;
    for (const int child : children[column]) {
      for (int i = begin_[child] + 1; i < begin_[child + 1]; ++i) {
        if (seen_in[rows_[i]] == column) continue;
        seen_in[rows_[i]] = column;
        rows.push_back(rows_[i]);
      }
    }
    std::sort(rows.begin(), rows.end());
    if (!rows.empty()) children[rows.front()].push_back(column);
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    begin_.push_back(static_cast<int>(rows_.size()));
  }
  blocks_.resize(rows_.size());
}

void BlockCholesky::FindTargets(const std::vector<Place>& places) {
  for (const Place& place : places) {
    const int row = column_of_[place.row];
    const int column = column_of_[place.column];
    targets_.push_back({IndexOf(std::max(row, column), std::min(row, column)), row < column});
  }
}

int BlockCholesky::IndexOf(int row, int column) const {
  const auto begin = rows_.begin() + begin_[column];
  const auto found = std::lower_bound(begin, rows_.begin() + begin_[column + 1], row);
  assert(*found == row);
  return static_cast<int>(found - rows_.begin());
}

bool BlockCholesky::Factorize(const std::vector<Eigen::Matrix3d>& diagonal,
                              const Eigen::VectorXd& damping,
                              const std::vector<Eigen::Matrix3d>& blocks) {
  const int size = static_cast<int>(eliminated_.size());
  std::fill(blocks_.begin(), blocks_.end(), Eigen::Matrix3d::Zero());
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    blocks_[targets_[i].index] =
        targets_[i].transposed ? Eigen::Matrix3d(blocks[i].transpose()) : blocks[i];
  }
  std::vector<Eigen::Matrix3d> column_blocks(size);  // of one column, by row
  std::vector<int> next_block = begin_;              // of each column that waits
  WaitingColumns waiting(size);
  for (int j = 0; j < size; ++j) {
    Eigen::Matrix3d& own = inverses_[j];
    own = diagonal[eliminated_[j]];
    own.diagonal() += damping.segment<3>(3 * eliminated_[j]);
    for (int p = begin_[j]; p < begin_[j + 1]; ++p) column_blocks[rows_[p]] = blocks_[p];
    for (int left = waiting.Take(j); left != kNone; left = waiting.Take(j)) {
      const int first = next_block[left]++;
      const Eigen::Matrix3d transposed = blocks_[first].transpose();
      own.noalias() -= blocks_[first] * transposed;
      for (int q = first + 1; q < begin_[left + 1]; ++q) {
        column_blocks[rows_[q]].noalias() -= blocks_[q] * transposed;
      }
      if (first + 1 < begin_[left + 1]) waiting.Wait(left, rows_[first + 1]);
    }
    if (!InvertFactor(&own)) return false;
    const Eigen::Matrix3d transposed = own.transpose();
    for (int p = begin_[j]; p < begin_[j + 1]; ++p) {
      blocks_[p].noalias() = column_blocks[rows_[p]] * transposed;
    }
    if (begin_[j] < begin_[j + 1]) waiting.Wait(j, rows_[begin_[j]]);
  }
  return true;
}

Eigen::VectorXd BlockCholesky::Solve(const Eigen::VectorXd& right) const {
  const int size = static_cast<int>(eliminated_.size());
  std::vector<Eigen::Vector3d> x(size);
  for (int j = 0; j < size; ++j) x[j] = right.segment<3>(3 * eliminated_[j]);
  for (int j = 0; j < size; ++j) {
    x[j] = inverses_[j] * x[j];
    for (int p = begin_[j]; p < begin_[j + 1]; ++p) x[rows_[p]].noalias() -= blocks_[p] * x[j];
  }
  for (int j = size - 1; j >= 0; --j) {
    for (int p = begin_[j]; p < begin_[j + 1]; ++p) {
      x[j].noalias() -= blocks_[p].transpose() * x[rows_[p]];
    }
    x[j] = inverses_[j].transpose() * x[j];
  }
  Eigen::VectorXd solution(right.size());
  for (int j = 0; j < size; ++j) solution.segment<3>(3 * eliminated_[j]) = x[j];
  return solution;
}

}  // namespace loopscope
