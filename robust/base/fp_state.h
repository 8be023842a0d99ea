// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/fp_state.h: what each thread knows about its floating point; found by fp_guard.h's
// probe.
#pragma once
#include <cstdint>
#include <cstring>

namespace veritope {

/// Part of every filter's error bound: it pays for underflow (docs/bounds/README.md, 4).
inline constexpr double kFilterFloor = 0x1p-900;

namespace internal {
/// kFilterFloor in a thread that computes as the bounds assume; infinite, so that no filter decides, in a thread that
/// does not or was not probed yet. A thread starts with infinity.
extern constinit thread_local double fp_floor __attribute__((tls_model("initial-exec")));
extern constinit thread_local bool fp_is_probed __attribute__((tls_model("initial-exec")));
/// The part of this state that a scope with another control word saves and restores.
struct FpState {
  double floor;
  bool is_probed;
};
FpState forget_fp() noexcept;
void restore_fp(FpState state) noexcept;
/// From construction to destruction this thread's filters do not decide: for scopes that round
/// otherwise on purpose.
class ScopedNoFilters {
 public:
  ScopedNoFilters() noexcept : outside_{fp_floor, fp_is_probed} {
    const std::uint64_t infinity = 0x7ff0000000000000u;  // a build with -ffast-math has no infinities
    std::memcpy(&fp_floor, &infinity, sizeof infinity);
    fp_is_probed = true;
  }
  ~ScopedNoFilters() {
    std::memcpy(&fp_floor, &outside_.floor, sizeof fp_floor);
    fp_is_probed = outside_.is_probed;
  }
  ScopedNoFilters(const ScopedNoFilters&) = delete;
  ScopedNoFilters& operator=(const ScopedNoFilters&) = delete;

 private:
  FpState outside_;
};
/// Probes; true if this thread's filters may decide.
bool probe_filters() noexcept;
}  // namespace internal

/// May this thread's filters decide? Probes at the first call in a thread.
bool filters_are_sound() noexcept;

/// Probes again: for a thread whose rounding mode, FTZ or DAZ changed after its first decision, say
/// because a library that was built with -ffast-math has been loaded. Sessions do it when they are
/// constructed. Takes approximately 100 ns.
void refresh_fp() noexcept;

}  // namespace veritope
