// SPDX-License-Identifier: LGPL-3.0-or-later
// render/transfer_function.h: which colour and which opacity the values of an attribute have in volume rendering.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace veritope {

/// The share exp(-extinction h) of light passes a path of length h through this value; the rest is replaced by light of
/// the colour.
struct TransferNode {
  double value = 0;
  std::array<double, 3> colour{};  ///< red, green, blue from 0 to 255
  double extinction = 0;           ///< for each unit of length
};

/// Linear between nodes, constant before the first and after the last one. Two nodes with one value are a jump.
class TransferFunction {
 public:
  /// REQUIRES nodes: one or more, finite numbers, ascending values, extinctions >= 0.
  explicit TransferFunction(std::vector<TransferNode> nodes);

  /// The mean of the extinction e and of e times the colour over the values between a and b: those of a piece of a ray
  /// along which the value changes linearly, however narrow nodes are. At a = b the values there.
  struct Mean {
    double extinction = 0;
    std::array<double, 3> glow{};
  };
  Mean mean(double a, double b) const;

 private:
  using Sums = std::array<double, 4>;  // of e and e times the three channels
  Sums at(double value) const;
  Sums integral(double value) const;  // from the first node's value
  std::size_t part_of(double value) const;

  std::vector<TransferNode> nodes_;
  std::vector<Sums> integrals_;  // at each node
};

/// exp(-x) for x >= 0 by +, - and * alone, so that every compiler gets the same bits; within 1e-12.
double exp_minus(double x);

}  // namespace veritope
