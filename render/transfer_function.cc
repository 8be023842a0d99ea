// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/transfer_function.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robust/base/check.h"

namespace veritope {
namespace {

// The four numbers at a share of the way from one node to the next.
std::array<double, 4> mixed(const TransferNode& a, const TransferNode& b, double share) {
  const double e = a.extinction + share * (b.extinction - a.extinction);
  std::array<double, 4> out{e};
  for (std::size_t c = 0; c < 3; ++c)
    out[c + 1] = e * (a.colour[c] + share * (b.colour[c] - a.colour[c]));
  return out;
}

// Their integrals over the share, from 0.
std::array<double, 4> mixed_integral(const TransferNode& a, const TransferNode& b, double share) {
  const double e = a.extinction, de = b.extinction - e;
  std::array<double, 4> out{share * (e + share * de / 2)};
  for (std::size_t c = 0; c < 3; ++c) {
    const double k = a.colour[c], dk = b.colour[c] - k;
    out[c + 1] = share * (e * k + share * ((e * dk + de * k) / 2 + share * de * dk / 3));
  }
  return out;
}

}  // namespace

TransferFunction::TransferFunction(std::vector<TransferNode> nodes) : nodes_(std::move(nodes)) {
  VT_CHECK(!nodes_.empty(), "a transfer function has a node");
  integrals_.resize(nodes_.size());
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
    const double width = nodes_[i + 1].value - nodes_[i].value;
    VT_CHECK(width >= 0 && std::isfinite(width), "the values of nodes ascend");
    const Sums part = mixed_integral(nodes_[i], nodes_[i + 1], 1);
    for (std::size_t c = 0; c < 4; ++c) integrals_[i + 1][c] = integrals_[i][c] + width * part[c];
  }
}

// The node at or before a value; the last but one at most. REQUIRES two nodes or more.
std::size_t TransferFunction::part_of(double value) const {
  const auto after =
      std::upper_bound(nodes_.begin(), nodes_.end(), value,
                       [](double v, const TransferNode& node) { return v < node.value; });
  const auto number = static_cast<std::size_t>(after - nodes_.begin());
  return std::clamp<std::size_t>(number, 1, nodes_.size() - 1) - 1;
}

TransferFunction::Sums TransferFunction::at(double value) const {
  if (value <= nodes_.front().value) return mixed(nodes_.front(), nodes_.front(), 0);
  if (value >= nodes_.back().value) return mixed(nodes_.back(), nodes_.back(), 0);
  const std::size_t i = part_of(value);
  const double width = nodes_[i + 1].value - nodes_[i].value;
  return mixed(nodes_[i], nodes_[i + 1], (value - nodes_[i].value) / width);
}

TransferFunction::Sums TransferFunction::integral(double value) const {
  const TransferNode &first = nodes_.front(), &last = nodes_.back();
  Sums out{}, part{};
  double width = 0;
  if (value <= first.value) {
    width = value - first.value;
    part = mixed(first, first, 0);
  } else if (value >= last.value) {
    width = value - last.value;
    part = mixed(last, last, 0);
    out = integrals_.back();
  } else {
    const std::size_t i = part_of(value);
    width = nodes_[i + 1].value - nodes_[i].value;
    part = mixed_integral(nodes_[i], nodes_[i + 1], (value - nodes_[i].value) / width);
    out = integrals_[i];
  }
  for (std::size_t c = 0; c < 4; ++c) out[c] += width * part[c];
  return out;
}

TransferFunction::Mean TransferFunction::mean(double a, double b) const {
  if (b < a) std::swap(a, b);
  // Differences of integrals are exact to a millionth for ranges that are wider.
  constexpr double kNarrow = 0x1p-30;
  const double size =
      std::max({nodes_.back().value - nodes_.front().value, std::abs(a), std::abs(b)});
  Sums sums{};
  if (b - a <= kNarrow * size) {
    sums = at(a + (b - a) / 2);
  } else {
    const Sums from = integral(a), to = integral(b);
    for (std::size_t c = 0; c < 4; ++c) sums[c] = std::max(0.0, (to[c] - from[c]) / (b - a));
  }
  return {sums[0], {sums[1], sums[2], sums[3]}};
}

double exp_minus(double x) {
  // exp(-x) = exp(-x / 1024)^1024, by a Taylor polynomial for x / 1024 < 1/25 and ten squares.
  if (!(x < 40)) return 0;
  const double t = x / 1024;
  double power = 1 - t * (1 - t / 2 * (1 - t / 3 * (1 - t / 4 * (1 - t / 5 * (1 - t / 6)))));
  for (int i = 0; i < 10; ++i) power *= power;
  return power;
}

}  // namespace veritope
