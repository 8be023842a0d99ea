// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/signal.h: the exceptions of IEEE 1788 as values beside the result; nothing is thrown.
#pragma once

namespace veritope {

enum class Signal {
  kNone,
  kUndefinedOperation,  ///< a constructor's arguments name no interval
  kIntervalPartOfNai,   ///< the interval of a NaI was requested
};

/// A result that is usable in any case, and what was wrong.
template <typename T>
struct Signalled {
  T value;
  Signal signal = Signal::kNone;
};

}  // namespace veritope
