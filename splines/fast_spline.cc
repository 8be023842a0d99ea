// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/fast_spline.h"

#include "robust/base/fp_guard.h"
#include "splines/fast_spline_tables_internal.h"

namespace veritope {
namespace {

const internal::FastKernels* kernels_of(FastBackEnd back_end) {
  if (back_end == FastBackEnd::kBaseline) return &internal::kFastBaseline;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return internal::fast_avx2();
#endif
  return nullptr;
}

}  // namespace

bool is_available(FastBackEnd back_end) { return kernels_of(back_end) != nullptr; }
FastBackEnd widest_fast_back_end() {
  static const FastBackEnd widest =
      is_available(FastBackEnd::kAvx2) ? FastBackEnd::kAvx2 : FastBackEnd::kBaseline;
  return widest;
}

template <std::size_t N>
struct FastSpline<N>::Data {
  internal::FastStorage<N> storage;
  internal::FastSplineTables tables;
  std::size_t dimension;
  int entry;  // in FastKernels: the degree if all are one and unrolled, else 0

  explicit Data(internal::FastStorage<N> s) : storage(std::move(s)), tables(storage.tables()) {
    dimension = static_cast<std::size_t>(storage.num_components) - (storage.is_rational ? 1 : 0);
    entry = storage.axes[0].degree;
    for (const auto& axis : storage.axes)
      if (axis.degree != entry || entry > internal::kFastDegrees) entry = 0;
  }
};

template <std::size_t N>
Result<FastSpline<N>> FastSpline<N>::prepare(const BSpline<Rational, N>& map) {
  auto storage = internal::make_fast_storage(map);
  if (!storage) return storage.error();
  return FastSpline(std::make_shared<const Data>(std::move(*storage)));
}

template <std::size_t N>
Result<FastSpline<N>> FastSpline<N>::prepare(const BSpline<double, N>& map) {
  auto exact = internal::exact_bspline(map);
  if (!exact) return exact.error();
  return prepare(*exact);
}

template <std::size_t N>
std::size_t FastSpline<N>::dimension() const {
  return data_->dimension;
}

template <std::size_t N>
std::array<double, 2> FastSpline<N>::domain(std::size_t axis) const {
  return {data_->storage.axes[axis].breaks.front(), data_->storage.axes[axis].breaks.back()};
}

template <std::size_t N>
void FastSpline<N>::evaluate(const std::array<const double*, N>& at, std::size_t n,
                             const FastSplineOutput& out) const {
  evaluate_on(widest_fast_back_end(), at, n, out);
}

template <std::size_t N>
void FastSpline<N>::evaluate_on(FastBackEnd back_end, const std::array<const double*, N>& at,
                                std::size_t n, const FastSplineOutput& out) const {
  VT_CHECK(out.value != nullptr && (out.partial != nullptr || out.partial_bound == nullptr),
           "a FastSpline writes values, and bounds of what it writes");
  const internal::FastKernels* const kernels = kernels_of(back_end);
  VT_CHECK(kernels != nullptr, "this processor lacks the back end's instructions");
  const auto entry = static_cast<std::size_t>(data_->entry);
  const ScopedDefaultFp nearest;
  (out.partial == nullptr ? kernels->value : kernels->jet)[N - 1][entry](
      data_->tables, at.data(), n, {out.value, out.value_bound, out.partial, out.partial_bound});
}

template class FastSpline<1>;
template class FastSpline<2>;
template class FastSpline<3>;

}  // namespace veritope
