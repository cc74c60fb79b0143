// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/number_codec.h"

#include <array>
#include <cstdint>

#include "core/io/bits.h"
#include "core/io/multiples.h"

namespace loopscope {
namespace {

/// Multiples of 1 / scale are tried in this order. Index 0 stands for none. Part of the format.
constexpr std::array<double, 14> kScales = {0.0, 1.0, 1e1, 1e2, 1e3,       1e4,       1e5,
                                            1e6, 1e7, 1e8, 1e9, 0x1.0p+20, 0x1.0p+24, 0x1.0p+30};

std::size_t NumExceptions(const std::vector<double>& values, double scale) {
  std::size_t count = 0;
  for (const double value : values) count += IsMultiple(value, scale) ? 0 : 1;
  return count;
}

/// Index of the scale that fits all values, or all but a few; 0 if none does.
std::uint8_t ChooseScale(const std::vector<double>& values) {
  std::uint8_t best = 0;
  std::size_t fewest = values.size() / 16 + 1;
  for (std::uint8_t i = 1; i < kScales.size() && fewest > 0; ++i) {
    const std::size_t count = NumExceptions(values, kScales[i]);
    if (count >= fewest) continue;
    best = i;
    fewest = count;
  }
  return best;
}

/// Guesses multiples from predictions, corrected by what was wrong about the last one, or from the
/// last multiple.
class MultiplePredictor {
 public:
  MultiplePredictor(const std::vector<double>& predictions, double scale)
      : predictions_(predictions), scale_(scale) {}

  std::int64_t Predict() const { return Base() + (index_ < predictions_.size() ? error_ : 0); }
  void Add(std::int64_t multiple) {
    error_ = index_ < predictions_.size() ? multiple - Base() : 0;
    last_ = multiple;
    ++index_;
  }

 private:
  std::int64_t Base() const {
    return index_ < predictions_.size() ? Multiple(predictions_[index_], scale_) : last_;
  }

  const std::vector<double>& predictions_;
  double scale_;
  std::size_t index_ = 0;
  std::int64_t last_ = 0;
  std::int64_t error_ = 0;
};

void PutMultiples(const std::vector<double>& values, const std::vector<double>& predictions,
                  double scale, ByteWriter* out) {
  out->PutUnsigned(NumExceptions(values, scale));
  std::size_t last_exception = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (IsMultiple(values[i], scale)) continue;
    out->PutUnsigned(i - last_exception);
    out->PutBits64(BitsOf(values[i]));
    last_exception = i;
  }
  MultiplePredictor predictor(predictions, scale);
  for (const double value : values) {
    const std::int64_t multiple = Multiple(value, scale);
    out->PutSigned(multiple - predictor.Predict());
    predictor.Add(multiple);
  }
}

struct Exception {
  std::size_t index;
  double value;
};

std::vector<Exception> GetExceptions(std::size_t num_values, ByteReader* in) {
  std::vector<Exception> exceptions(in->GetCount(9));
  std::size_t index = 0;
  for (Exception& exception : exceptions) {
    const std::uint64_t step = in->GetUnsigned();
    if (step >= num_values - index) in->Fail("a place is outside");
    index += static_cast<std::size_t>(step);
    exception = {index, DoubleOf(in->GetBits64())};
  }
  return exceptions;
}

std::vector<double> GetMultiples(std::size_t num_values, const std::vector<double>& predictions,
                                 double scale, ByteReader* in) {
  const std::vector<Exception> exceptions = GetExceptions(num_values, in);
  MultiplePredictor predictor(predictions, scale);
  std::vector<double> values(num_values);
  for (double& value : values) {
    const std::int64_t multiple = GetMultiple(predictor.Predict(), in);
    value = FromMultiple(multiple, scale);
    predictor.Add(multiple);
  }
  for (const Exception& exception : exceptions) values[exception.index] = exception.value;
  return values;
}

std::uint64_t PredictedBits(const std::vector<double>& predictions, std::size_t index,
                            std::uint64_t last_bits) {
  return index < predictions.size() ? BitsOf(predictions[index]) : last_bits;
}

/// The bytes of the same weight stand together: the high ones are alike.
void PutBits(const std::vector<double>& values, const std::vector<double>& predictions,
             ByteWriter* out) {
  for (int shift = 0; shift < 64; shift += 8) {
    std::uint64_t last = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::uint64_t bits = BitsOf(values[i]);
      out->PutByte(
          static_cast<std::uint8_t>((bits ^ PredictedBits(predictions, i, last)) >> shift));
      last = bits;
    }
  }
}

std::vector<double> GetBits(std::size_t num_values, const std::vector<double>& predictions,
                            ByteReader* in) {
  std::vector<std::uint64_t> differences(num_values, 0);
  for (int shift = 0; shift < 64; shift += 8) {
    for (std::uint64_t& difference : differences) {
      difference |= std::uint64_t{in->GetByte()} << shift;
    }
  }
  std::vector<double> values;
  values.reserve(num_values);
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < num_values; ++i) {
    last = differences[i] ^ PredictedBits(predictions, i, last);
    values.push_back(DoubleOf(last));
  }
  return values;
}

std::vector<double> Column(const std::vector<Pose2>& poses, int column) {
  std::vector<double> values;
  values.reserve(poses.size());
  for (const Pose2& pose : poses) {
    values.push_back(column < 2 ? pose.translation[column] : pose.rotation);
  }
  return values;
}

}  // namespace

void PutDoubles(const std::vector<double>& values, const std::vector<double>& predictions,
                ByteWriter* out) {
  const std::uint8_t scale = ChooseScale(values);
  out->PutUnsigned(values.size());
  out->PutByte(scale);
  if (scale == 0) {
    PutBits(values, predictions, out);
  } else {
    PutMultiples(values, predictions, kScales[scale], out);
  }
}

std::vector<double> GetDoubles(const std::vector<double>& predictions, ByteReader* in) {
  const std::size_t num_values = in->GetCount();
  const std::uint8_t scale = in->GetByte();
  if (scale >= kScales.size()) in->Fail("an unknown scale");
  return scale == 0 ? GetBits(num_values, predictions, in)
                    : GetMultiples(num_values, predictions, kScales[scale], in);
}

void PutPoses(const std::vector<Pose2>& poses, const std::vector<Pose2>& predictions,
              ByteWriter* out) {
  for (int column = 0; column < 3; ++column) {
    PutDoubles(Column(poses, column), Column(predictions, column), out);
  }
}

std::vector<Pose2> GetPoses(const std::vector<Pose2>& predictions, ByteReader* in) {
  const std::vector<double> x = GetDoubles(Column(predictions, 0), in);
  const std::vector<double> y = GetDoubles(Column(predictions, 1), in);
  const std::vector<double> rotation = GetDoubles(Column(predictions, 2), in);
  if (x.size() != y.size() || x.size() != rotation.size()) in->Fail("columns differ in length");
  std::vector<Pose2> poses;
  poses.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) poses.emplace_back(x[i], y[i], rotation[i]);
  return poses;
}

}  // namespace loopscope
