// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/itd_spline_reader.h: CURVE, SURFACE, TRIVAR and MULTIVAR of IRIT's .itd.
#pragma once
#include "io/splines/itd_lexer.h"

namespace veritope {

class ItdSplineReader : public ItdLexer {
 public:
  using ItdLexer::ItdLexer;

 protected:
  /// Reads from after the keyword to after the closing bracket; places an error of the whole at `open`. N = 1, 2, 3.
  template <std::size_t N>
  bool read_spline(const char* open, std::optional<BSpline<Rational, N>>& spline,
                   std::vector<std::string>& attributes);
  /// Reads a whole [KEYWORD ...] whose attributes are dropped. N = 1, 2.
  template <std::size_t N>
  bool read_inner(const char* keyword, std::optional<BSpline<Rational, N>>& spline);
  /// Reads MULTIVAR. is_known: whether it has up to three parameters; otherwise it was left out.
  bool read_multivariate(const char* open, SplineEntity& entity, bool& is_known);

 private:
  enum class Basis { kBezier, kBspline, kPower };
  /// Reads what lies between the keyword and the knots.
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
