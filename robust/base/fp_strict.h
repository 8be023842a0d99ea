// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/fp_strict.h: refuses compiler settings under which the filters' error bounds do not
// hold. Every header with inline floating-point decisions includes it. What only shows at run time
// is fp_guard.h's.
#pragma once

#if defined(__FAST_MATH__)
#error \
    "veritope: -ffast-math (or -Ofast) lets the compiler change rounding errors that the predicates count on"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0
#error "veritope: -ffinite-math-only removes the tests that send overflow and NaN to the exact tier"
#endif
#if defined(__ASSOCIATIVE_MATH__)
#error "veritope: -fassociative-math reorders sums whose rounding errors are counted"
#endif
#if defined(__RECIPROCAL_MATH__)
#error "veritope: -freciprocal-math replaces divisions by products with another rounding error"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error "veritope: binary64 is evaluated with excess precision (x87?); use -mfpmath=sse -msse2"
#endif
