// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/ball/ball.h"

namespace veritope {

bool is_solid(const Ball& ball) { return ball.radius.digits > 0; }

double approx_value(const ShortDecimal& number) {
  double power = 1;  // exact: at most 10^18
  for (int i = 0; i < number.decimals; ++i) power *= 10;
  return static_cast<double>(number.digits) / power;
}

}  // namespace veritope
