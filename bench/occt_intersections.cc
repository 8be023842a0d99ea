// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/occt_intersections.h"

#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_IntSS.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomInt_IntSS.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pnt2d.hxx>

namespace veritope::bench {
namespace {

Handle(Geom_BSplineSurface) converted(const BSplineSurface<Rational>& s) {
  const auto grid = s.grid();
  TColgp_Array2OfPnt poles(1, static_cast<int>(grid.size[0]), 1, static_cast<int>(grid.size[1]));
  for (std::size_t i = 0; i < grid.size[0]; ++i)
    for (std::size_t j = 0; j < grid.size[1]; ++j) {
      const std::size_t k = grid.at({i, j});
      poles(static_cast<int>(i) + 1, static_cast<int>(j) + 1) =
          gp_Pnt(nearest_double(s.component(0)[k]), nearest_double(s.component(1)[k]),
                 nearest_double(s.component(2)[k]));
    }
  std::array<std::vector<double>, 2> knots;
  std::array<std::vector<int>, 2> times;
  for (std::size_t a = 0; a < 2; ++a)
    for (const Rational& k : s.axis(a).knots) {
      const double v = nearest_double(k);
      if (knots[a].empty() || knots[a].back() != v) knots[a].push_back(v), times[a].push_back(0);
      ++times[a].back();
    }
  const auto reals = [](const std::vector<double>& v) {
    TColStd_Array1OfReal out(1, static_cast<int>(v.size()));
    for (std::size_t i = 0; i < v.size(); ++i) out(static_cast<int>(i) + 1) = v[i];
    return out;
  };
  const auto integers = [](const std::vector<int>& v) {
    TColStd_Array1OfInteger out(1, static_cast<int>(v.size()));
    for (std::size_t i = 0; i < v.size(); ++i) out(static_cast<int>(i) + 1) = v[i];
    return out;
  };
  return new Geom_BSplineSurface(poles, reals(knots[0]), reals(knots[1]), integers(times[0]),
                                 integers(times[1]), s.axis(0).degree, s.axis(1).degree);
}

}  // namespace

struct OcctPair::State {
  Handle(Geom_BSplineSurface) first, second;
  GeomAPI_IntSS result;
};

OcctPair::OcctPair(const BSplineSurface<Rational>& first, const BSplineSurface<Rational>& second)
    : state_(new State) {
  state_->first = converted(first), state_->second = converted(second);
}
OcctPair::~OcctPair() = default;

int OcctPair::intersect(double tolerance) {
  state_->result.Perform(state_->first, state_->second, tolerance);
  return state_->result.IsDone() ? state_->result.NbLines() : 0;
}

double OcctPair::length() const {
  double out = 0;
  for (int i = 1; i <= state_->result.NbLines(); ++i) {
    const GeomAdaptor_Curve curve(state_->result.Line(i));
    out += GCPnts_AbscissaPoint::Length(curve);
  }
  return out;
}

std::vector<std::vector<std::array<double, 4>>> OcctPair::sample(double tolerance,
                                                                 int points) const {
  std::vector<std::vector<std::array<double, 4>>> out;
  GeomInt_IntSS again;  // GeomAPI_IntSS gives no curves in the parameters
  again.Perform(state_->first, state_->second, tolerance, true, true, true);
  for (int i = 1; again.IsDone() && i <= again.NbLines(); ++i) {
    auto& line = out.emplace_back();
    if (!again.HasLineOnS1(i) || !again.HasLineOnS2(i)) continue;
    const Handle(Geom2d_Curve) a = again.LineOnS1(i), b = again.LineOnS2(i);
    const double begin = a->FirstParameter(), end = a->LastParameter();
    for (int k = 0; k < points; ++k) {
      const double t = begin + (end - begin) * k / (points - 1);
      const gp_Pnt2d p = a->Value(t), q = b->Value(t);
      line.push_back({p.X(), p.Y(), q.X(), q.Y()});
    }
  }
  return out;
}

}  // namespace veritope::bench
