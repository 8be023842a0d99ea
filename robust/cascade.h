// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/cascade.h: asks the cheapest tier first and the exact one last. It knows no geometry and no number type.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"

/// For the lambdas that are a cascade's tiers: one that is not inlined, because it is rarely asked,
/// forces the operands of the frequent ones into memory.
#define VT_TIER __attribute__((always_inline))

namespace veritope {

/// The tiers of the predicates, in the order in which they are asked.
enum class Tier : std::size_t {
  kFilter,   ///< binary64 with an error bound derived beforehand (docs/bounds)
  kLattice,  ///< exact, in machine integers, if one power of two turns the operands into short ones
  kInterval,  ///< binary64 with outward rounding
  kExact,     ///< exact for all finite operands
};
inline constexpr std::size_t kNumTiers = 4;

/// Does the tier compute in floating point, on which it then depends?
constexpr bool is_floating(Tier tier) { return tier == Tier::kFilter || tier == Tier::kInterval; }

/// How often each tier decided. Not shared between threads: give each its own and add them up.
struct TierCounts {
  std::array<std::uint64_t, kNumTiers> decided{};

  std::uint64_t operator[](Tier tier) const { return decided[static_cast<std::size_t>(tier)]; }
  TierCounts& operator+=(const TierCounts& other) {
    for (std::size_t i = 0; i < kNumTiers; ++i) decided[i] += other.decided[i];
    return *this;
  }
  friend bool operator==(const TierCounts&, const TierCounts&) = default;
};

#if defined(VT_AUDIT)
inline constexpr bool kCascadesAreAudited = true;
#else
inline constexpr bool kCascadesAreAudited = false;
#endif

namespace internal {
/// Writes what contradicts what to stderr, since a cascade may be noexcept; throws InternalError.
[[noreturn]] void audit_failed(Tier tier, Sign says, const TierCounts& other, Sign contradicts);
}  // namespace internal

/// The answer of the first tier that is certain. Each argument is asked at most once, in order:
///   `Sign3 tier()`            may be uncertain; not allowed in the last place;
///   `Sign tier()`             always answers; the last place;
///   `Sign rest(TierCounts*)`  the last place: a cascade that goes on from here and keeps the tally itself.
/// If `tally` is not null, the tier that answers is counted at position First, First + 1, ...; a
/// constant null costs nothing.
/// Audit mode (VT_AUDIT in all translation units: CMake's VERITOPE_AUDIT): the later tiers are asked, too, uncounted,
/// each at most once; if one contradicts the answer, that is our bug, an InternalError.
template <std::size_t First = 0, typename T, typename... Rest>
[[gnu::always_inline]] constexpr Sign cascade(TierCounts* tally, T&& tier, Rest&&... rest) {
  if constexpr (sizeof...(Rest) == 0) {
    if constexpr (std::is_invocable_r_v<Sign, T, TierCounts*>) {
      return tier(tally);
    } else {
      static_assert(std::is_same_v<std::invoke_result_t<T>, Sign>, "the last tier always answers");
      static_assert(First < kNumTiers);
      if (tally != nullptr) ++tally->decided[First];
      return tier();
    }
  } else {
    static_assert(std::is_same_v<std::invoke_result_t<T>, Sign3>,
                  "only the last tier returns Sign");
    static_assert(First < kNumTiers);
    if constexpr (!kFiltersAreCompiled && is_floating(static_cast<Tier>(First))) {
      return cascade<First + 1>(tally, std::forward<Rest>(rest)...);
    }
    const Sign3 s = tier();
    if (is_certain(s)) [[likely]] {
      if (tally != nullptr) ++tally->decided[First];
      if constexpr (kCascadesAreAudited) {
        TierCounts other;  // the rest is audited in turn: it speaks for all its certain tiers
        const Sign later = cascade<First + 1>(&other, std::forward<Rest>(rest)...);
        if (later != to_sign(s)) {
          internal::audit_failed(static_cast<Tier>(First), to_sign(s), other, later);
        }
      }
      return to_sign(s);
    }
    return cascade<First + 1>(tally, std::forward<Rest>(rest)...);
  }
}

}  // namespace veritope
