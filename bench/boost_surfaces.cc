// SPDX-License-Identifier: LGPL-3.0-or-later
// Boost.Interval's enclosures of points of a surface; compiled with -frounding-math.
#include <algorithm>
#include <boost/numeric/interval.hpp>

#include "bench/spline_peers.h"

namespace veritope::bench {
namespace {

struct NoScope {
  NoScope() {}
};
using Default = boost::numeric::interval<double>;
using Unprotected = boost::numeric::interval_lib::unprotect<Default>::type;

template <typename T, typename Scope>
class BoostSurface : public SurfacePeer {
 public:
  BoostSurface(std::string name, const SurfaceData& data)
      : SurfacePeer(std::move(name)), data_(data) {
    for (const auto& p : data.points)
      for (const double x : p) points_.push_back(T(x));
  }
  void run(const double* u, const double* v, std::size_t n, double* out, double*,
           double*) override {
    const Scope scope;
    for (std::size_t k = 0; k < n; ++k) {
      T bu[4], bv[4];
      const std::size_t i = basis(data_.knots_u, data_.num_u, u[k], bu);
      const std::size_t j = basis(data_.knots_v, data_.num_v, v[k], bv);
      T sum[3] = {T(0.0), T(0.0), T(0.0)};
      for (std::size_t a = 0; a < 4; ++a) {
        T row[3] = {T(0.0), T(0.0), T(0.0)};
        for (std::size_t b = 0; b < 4; ++b)
          for (std::size_t c = 0; c < 3; ++c)
            row[c] += bv[b] * points_[3 * ((i + a) * data_.num_v + j + b) + c];
        for (std::size_t c = 0; c < 3; ++c) sum[c] += bu[a] * row[c];
      }
      for (std::size_t c = 0; c < 3; ++c) out[3 * k + c] = 0.5 * (sum[c].lower() + sum[c].upper());
    }
  }

 private:
  // Computes the four basis functions that are not zero at x, and the index of the first one.
  static std::size_t basis(const std::vector<double>& t, std::size_t num, double x, T* b) {
    const auto above =
        std::upper_bound(t.begin() + 4, t.begin() + static_cast<std::ptrdiff_t>(num), x);
    const auto k = static_cast<std::size_t>(above - t.begin()) - 1;
    T left[4], right[4];
    b[0] = T(1.0);
    for (std::size_t j = 1; j <= 3; ++j) {
      left[j] = T(x) - T(t[k + 1 - j]), right[j] = T(t[k + j]) - T(x);
      T saved(0.0);
      for (std::size_t r = 0; r < j; ++r) {
        const T part = b[r] / (right[r + 1] + left[j - r]);
        b[r] = saved + right[r + 1] * part;
        saved = left[j - r] * part;
      }
      b[j] = saved;
    }
    return k - 3;
  }
  SurfaceData data_;
  std::vector<T> points_;
};

}  // namespace

void add_boost_surfaces(const SurfaceData& data, SurfacePeers& out) {
  out.push_back(std::make_unique<BoostSurface<Default, NoScope>>("boost_interval", data));
  out.push_back(std::make_unique<BoostSurface<Unprotected, Default::traits_type::rounding>>(
      "boost_interval_unprotected", data));
}

}  // namespace veritope::bench
