// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/itd_spline_reader.h: CURVE, SURFACE, TRIVAR and MULTIVAR of IRIT's .itd.
#pragma once
#include "io/splines/itd_lexer.h"

namespace veritope {

class ItdSplineReader : public ItdLexer {
 public:
  using ItdLexer::ItdLexer;

 protected:
  /// From after the keyword to after the closing bracket; an error of the whole is placed at `open`. N = 1, 2, 3.
  template <std::size_t N>
  bool read_spline(const char* open, std::optional<BSpline<Rational, N>>& spline,
                   std::vector<std::string>& attributes);
  /// A whole [KEYWORD ...] whose attributes are dropped. N = 1, 2.
  template <std::size_t N>
  bool read_inner(const char* keyword, std::optional<BSpline<Rational, N>>& spline);
  /// MULTIVAR; is_known: it has up to three parameters, else it was left out.
  bool read_multivariate(const char* open, SplineEntity& entity, bool& is_known);

 private:
  enum class Basis { kBezier, kBspline, kPower };
  /// What follows the keyword, before the knots.
  template <std::size_t N>
  struct Header {
    Basis basis = Basis::kBspline;
    RawSpline<N> raw;
    std::array<std::uint64_t, N> orders{};
  };

  bool read_basis(Basis& basis, std::vector<std::string>& attributes);
  template <std::size_t N>
  bool read_header(Header<N>& header);
  bool read_point_type(int& components, bool& is_rational);
  template <std::size_t N>
  bool read_knots(Header<N>& header);
  template <std::size_t N>
  bool read_points(RawSpline<N>& raw);
  template <std::size_t N>
  bool read_body(const char* open, Header<N>& header, std::optional<BSpline<Rational, N>>& spline);
  template <std::size_t N>
  bool read_multivariate_of(const char* open, Basis basis, SplineEntity& entity);
};

}  // namespace veritope
