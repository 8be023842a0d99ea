// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/fp_strict.h: what the compiler's macros show. The filters' error bounds hold for IEEE 754 operations,
// rounded one at a time; where a translation unit may not have them, its filters and intervals are left out, and
// integers decide: more slowly, and equally right. fp_guard.h detects what only shows at run time.
#pragma once

/// 1 if this translation unit's filters and intervals are left out.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                          \
    (defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0)
#define VT_NO_FILTERS 1
#else
#define VT_NO_FILTERS 0
#endif

/// Around code that relies on IEEE 754: clang has no macros for parts of -ffast-math, but a pragma that switches them
/// off.
#if defined(__clang__)
#define VT_PRECISE_BEGIN _Pragma("float_control(precise, on, push)")
#define VT_PRECISE_END _Pragma("float_control(pop)")
#else
#define VT_PRECISE_BEGIN
#define VT_PRECISE_END
#endif

/// 1 if products and sums may be fused: no macro shows whether -ffp-contract=off is given.
#if defined(__FMA__) || defined(__FMA4__) || !defined(__x86_64__)
#define VT_MAY_CONTRACT 1
#else
#define VT_MAY_CONTRACT 0
#endif

namespace veritope {
inline constexpr bool kFiltersAreCompiled = VT_NO_FILTERS == 0;
}  // namespace veritope
