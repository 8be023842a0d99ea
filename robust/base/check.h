// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/check.h: assertions about our own code. Bad input is never reported this way: see result.h.
#pragma once
#include <stdexcept>
#include <string>

namespace veritope {

/// A bug of ours. Only the command line and the bindings catch it.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace internal {
[[noreturn]] void check_failed(const char* condition, const char* why, const char* file, int line);
}  // namespace internal

}  // namespace veritope

/// Throws InternalError unless `cond`; on in every build.
#define VT_CHECK(cond, why) \
  ((cond) ? static_cast<void>(0) \
          : ::veritope::internal::check_failed(#cond, why, __FILE__, __LINE__))

/// A check that costs more than the function that it guards: on in debug and fuzz builds.
#if defined(VERITOPE_SLOW_CHECKS) || !defined(NDEBUG)
#define VT_SLOW_CHECK(cond, why) VT_CHECK(cond, why)
#else
#define VT_SLOW_CHECK(cond, why) static_cast<void>(0)
#endif
