// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/side_batch_internal.h: the loop of side_batch.h over a vector of lanes. A back end's file is
// compiled with the flags of its instruction set, and so includes nothing else that the linker could
// share with files that must run everywhere.
#pragma once
#include <cstddef>

namespace veritope::internal {

/// What the filter keeps of a plane: a, the normal, and the sums of the absolute products that make
/// it. With w = d - a: det = w . normal, error = rel (|w| . weight) + (eta |w|_1 + abs).
struct SidePlane {
  double origin[3], normal[3], weight[3];
  double rel, eta, abs;
};

/// Writes -1, 1 or 2 (uncertain) for each of n points. REQUIRES round to nearest, gradual underflow.
using SideKernel = void (*)(const SidePlane& plane, const double* x, const double* y,
                            const double* z, std::size_t n, int* out);
void side_baseline(const SidePlane& plane, const double* x, const double* y, const double* z,
                   std::size_t n, int* out);
// Null where the compiler cannot generate such code.
SideKernel side_avx2();
SideKernel side_avx512();

namespace {

// V has: kLanes; load, load_part (0 < count < kLanes), all; add, sub, mul to nearest; abs; store_signs(det, error, out,
// count), which stores sign_beyond(det, error) of robust/filter.h.
template <typename V>
struct SideLoop {
  V ox, oy, oz, nx, ny, nz, gx, gy, gz, rel, eta, least;

  explicit SideLoop(const SidePlane& p)
      : ox(V::all(p.origin[0])),
        oy(V::all(p.origin[1])),
        oz(V::all(p.origin[2])),
        nx(V::all(p.normal[0])),
        ny(V::all(p.normal[1])),
        nz(V::all(p.normal[2])),
        gx(V::all(p.weight[0])),
        gy(V::all(p.weight[1])),
        gz(V::all(p.weight[2])),
        rel(V::all(p.rel)),
        eta(V::all(p.eta)),
        least(V::all(p.abs)) {}

  // These are the operations of orient3d.h in their order, so that the bits are the same.
  [[gnu::always_inline]] void decide(V x, V y, V z, int* out, std::size_t count) const {
    const V wx = V::sub(x, ox), wy = V::sub(y, oy), wz = V::sub(z, oz);
    const V ax = V::abs(wx), ay = V::abs(wy), az = V::abs(wz);
    const V det = V::add(V::add(V::mul(wx, nx), V::mul(wy, ny)), V::mul(wz, nz));
    const V sum = V::add(V::add(V::mul(ax, gx), V::mul(ay, gy)), V::mul(az, gz));
    const V size = V::add(V::add(ax, ay), az);
    const V error = V::add(V::mul(rel, sum), V::add(V::mul(eta, size), least));
    V::store_signs(det, error, out, count);
  }
  static void run(const SidePlane& plane, const double* x, const double* y, const double* z,
                  std::size_t n, int* out) {
    const SideLoop loop(plane);
    std::size_t i = 0;
    for (; i + V::kLanes <= n; i += V::kLanes)
      loop.decide(V::load(x + i), V::load(y + i), V::load(z + i), out + i, V::kLanes);
    const std::size_t rest = n - i;
    if (rest > 0) {
      loop.decide(V::load_part(x + i, rest), V::load_part(y + i, rest), V::load_part(z + i, rest),
                  out + i, rest);
    }
  }
};

}  // namespace
}  // namespace veritope::internal
