// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/spline_peers.h: other libraries' evaluation of one bicubic surface in space, each compiled in a file of its own
// with the flags that its library needs.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace veritope::bench {

/// A clamped bicubic B-spline on [0, 1]^2 with uniform spans; points row by row, the second parameter fastest.
struct SurfaceData {
  std::size_t num_u = 0, num_v = 0;
  std::vector<double> knots_u, knots_v;  // multiplicities written out
  std::vector<std::array<double, 3>> points;
};

class SurfacePeer {
 public:
  explicit SurfacePeer(std::string name) : name(std::move(name)) {}
  virtual ~SurfacePeer() = default;
  /// Computes points at n parameters, out[3 i + c], and the derivatives by u and v in du, dv if
  /// they are not null.
  virtual void run(const double* u, const double* v, std::size_t n, double* out, double* du,
                   double* dv) = 0;
  std::string name;
};

using SurfacePeers = std::vector<std::unique_ptr<SurfacePeer>>;
/// D0 and D1 of Geom_BSplineSurface, and of GeomAdaptor_Surface, which caches the last span.
void add_occt_surfaces(const SurfaceData& data, SurfacePeers& out);
/// Enclosures, of which the middle is returned: basis functions by Cox and de Boor, 16 products.
void add_boost_surfaces(const SurfaceData& data, SurfacePeers& out);

}  // namespace veritope::bench
