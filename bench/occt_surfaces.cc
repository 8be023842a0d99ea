// SPDX-License-Identifier: LGPL-3.0-or-later
// Open CASCADE's surfaces, a peer of bench_splines.cc only.
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "bench/spline_peers.h"

namespace veritope::bench {
namespace {

struct Knots {
  TColStd_Array1OfReal knots;
  TColStd_Array1OfInteger times;
  explicit Knots(const std::vector<double>& all) : knots(1, count(all)), times(1, count(all)) {
    int k = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i == 0 || all[i] != all[i - 1]) ++k, knots.SetValue(k, all[i]), times.SetValue(k, 0);
      times.SetValue(k, times.Value(k) + 1);
    }
  }
  static int count(const std::vector<double>& all) {
    int k = 0;
    for (std::size_t i = 0; i < all.size(); ++i) k += i == 0 || all[i] != all[i - 1];
    return k;
  }
};

Handle(Geom_BSplineSurface) make_surface(const SurfaceData& data) {
  const int nu = static_cast<int>(data.num_u), nv = static_cast<int>(data.num_v);
  TColgp_Array2OfPnt points(1, nu, 1, nv);
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const auto& p = data.points[static_cast<std::size_t>(i * nv + j)];
      points.SetValue(i + 1, j + 1, gp_Pnt(p[0], p[1], p[2]));
    }
  const Knots u(data.knots_u), v(data.knots_v);
  return new Geom_BSplineSurface(points, u.knots, v.knots, u.times, v.times, 3, 3);
}

template <typename Surface>
void evaluate(const Surface& surface, const double* u, const double* v, std::size_t n, double* out,
              double* du, double* dv) {
  gp_Pnt p;
  gp_Vec a, b;
  for (std::size_t i = 0; i < n; ++i) {
    if (du == nullptr) {
      surface.D0(u[i], v[i], p);
    } else {
      surface.D1(u[i], v[i], p, a, b);
      for (int c = 0; c < 3; ++c) du[3 * i + c] = a.Coord(c + 1), dv[3 * i + c] = b.Coord(c + 1);
    }
    for (int c = 0; c < 3; ++c) out[3 * i + c] = p.Coord(c + 1);
  }
}

class Plain : public SurfacePeer {
 public:
  explicit Plain(const SurfaceData& data)
      : SurfacePeer("occt_geom"), surface_(make_surface(data)) {}
  void run(const double* u, const double* v, std::size_t n, double* out, double* du,
           double* dv) override {
    evaluate(*surface_, u, v, n, out, du, dv);
  }

 private:
  Handle(Geom_BSplineSurface) surface_;
};
class Cached : public SurfacePeer {
 public:
  explicit Cached(const SurfaceData& data)
      : SurfacePeer("occt_cached"), surface_(make_surface(data)) {}
  void run(const double* u, const double* v, std::size_t n, double* out, double* du,
           double* dv) override {
    evaluate(surface_, u, v, n, out, du, dv);
  }

 private:
  GeomAdaptor_Surface surface_;
};

}  // namespace

void add_occt_surfaces(const SurfaceData& data, SurfacePeers& out) {
  out.push_back(std::make_unique<Plain>(data));
  out.push_back(std::make_unique<Cached>(data));
}

}  // namespace veritope::bench
