// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/composition_remainders.h"

namespace veritope::internal {

using Number = PrimeField::Number;

AxisMatrix AxisMatrix::powers(const PrimeField& field, std::size_t rows, std::size_t columns) {
  AxisMatrix matrix{rows, columns, {}};
  for (std::size_t z = 0; z < rows; ++z) {
    Number power = 1;
    for (std::size_t i = 0; i < columns; ++i, power = field.multiply(power, z))
      matrix.entries.push_back(power);
  }
  return matrix;
}

// Column z holds the coefficients of Lagrange's polynomial of the node z: the product of t - s over all other nodes s,
// which is the product over all nodes divided by t - z, over z! (size - 1 - z)! (-1)^(size - 1 - z).
AxisMatrix AxisMatrix::interpolation(const PrimeField& field, std::size_t size) {
  std::vector<Number> all{1};  // of all nodes; all[i]: of t^i
  for (std::size_t s = 0; s < size; ++s) {
    all.push_back(0);
    for (std::size_t i = all.size(); i-- > 0;)
      all[i] = field.subtract(i > 0 ? all[i - 1] : 0, field.multiply(all[i], s));
  }
  std::vector<Number> factorial{1};
  for (std::size_t i = 1; i < size; ++i) factorial.push_back(field.multiply(factorial.back(), i));
  AxisMatrix matrix{size, size, std::vector<Number>(size * size)};
  for (std::size_t z = 0; z < size; ++z) {
    const std::size_t above = size - 1 - z;
    Number scale = field.inverse(field.multiply(factorial[z], factorial[above]));
    if (above % 2 == 1) scale = field.subtract(0, scale);
    Number quotient = 0;
    for (std::size_t i = size; i-- > 0;) {
      quotient = field.add(all[i + 1], field.multiply(quotient, z));
      matrix.entries[i * size + z] = field.multiply(quotient, scale);
    }
  }
  return matrix;
}

}  // namespace veritope::internal
