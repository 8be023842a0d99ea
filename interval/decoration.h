// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/decoration.h: what an evaluation knows about the function besides its range. Source:
// [IEEE1788] 8.2, with the values of its table 14.1.
#pragma once

namespace veritope {

/// Statements about f on the box x where it was evaluated, from weakest to strongest.
enum class Decoration : int {
  kIll = 0,   ///< no interval at all (NaI): a constructor failed
  kTrv = 4,   ///< nothing is known
  kDef = 8,   ///< f is defined at every point of x, and x is nonempty
  kDac = 12,  ///< and f restricted to x is continuous
  kCom = 16,  ///< and x is bounded, f is continuous at each of its points, the result is bounded
};

constexpr Decoration weakest(Decoration a, Decoration b) { return a < b ? a : b; }

}  // namespace veritope
