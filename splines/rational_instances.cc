// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/rational_instances.cc: the exact algebra that most units above use, compiled here only. Each header declares
// its instances as extern; the list below must name the same ones, or a program that uses one does not link.
#include "splines/bezier_degree.h"
#include "splines/bezier_product.h"
#include "splines/bspline_pieces.h"
#include "splines/knot_insertion.h"

namespace veritope {

template BSpline<Rational, 1> refine(const BSpline<Rational, 1>&, std::size_t,
                                     const std::vector<Rational>&);
template BSpline<Rational, 2> refine(const BSpline<Rational, 2>&, std::size_t,
                                     const std::vector<Rational>&);
template BSpline<Rational, 3> refine(const BSpline<Rational, 3>&, std::size_t,
                                     const std::vector<Rational>&);
template BezierPieces<Rational, 1> bezier_pieces(BSpline<Rational, 1>);
template BezierPieces<Rational, 2> bezier_pieces(BSpline<Rational, 2>);
template BezierPieces<Rational, 3> bezier_pieces(BSpline<Rational, 3>);
template Bezier<Rational, 1> elevate(const Bezier<Rational, 1>&, std::size_t, int);
template Bezier<Rational, 2> elevate(const Bezier<Rational, 2>&, std::size_t, int);
template Bezier<Rational, 3> elevate(const Bezier<Rational, 3>&, std::size_t, int);
template Bezier<Rational, 1> componentwise_product(const Bezier<Rational, 1>&,
                                                   const Bezier<Rational, 1>&);
template Bezier<Rational, 2> componentwise_product(const Bezier<Rational, 2>&,
                                                   const Bezier<Rational, 2>&);
template Bezier<Rational, 3> componentwise_product(const Bezier<Rational, 3>&,
                                                   const Bezier<Rational, 3>&);
template BSpline<Rational, 1> joined(const BezierPieces<Rational, 1>&);
template BSpline<Rational, 2> joined(const BezierPieces<Rational, 2>&);
template BSpline<Rational, 3> joined(const BezierPieces<Rational, 3>&);

}  // namespace veritope
