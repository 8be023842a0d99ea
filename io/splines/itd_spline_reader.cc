// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/itd_spline_reader.h"

namespace veritope {

bool ItdSplineReader::read_point_type(int& components, bool& is_rational) {
  const std::string_view token = peek();
  const bool is_type = token.size() == 2 && (token[0] == 'E' || token[0] == 'P') &&
                       token[1] >= '1' && token[1] <= '9';
  if (!is_type) return fail_expected("a point type, E1 to E9 or P1 to P9,");
  is_rational = token[0] == 'P';
  components = token[1] - '0' + (is_rational ? 1 : 0);
  p_ += 2;
  return true;
}

bool ItdSplineReader::read_basis(Basis& basis, std::vector<std::string>& attributes) {
  std::string word;
  skip();
  const char* const start = p_;
  if (!take_word(word)) return false;
  if (word == "BEZIER") {
    basis = Basis::kBezier;
  } else if (word == "POWER") {
    basis = Basis::kPower;
  } else if (word == "BSPLINE") {
    basis = Basis::kBspline;
  } else {
    return fail(start, Code::kSyntax,
                "BSPLINE, BEZIER or POWER expected, but there is " + quoted(word));
  }
  return read_attributes(attributes);
}

template <std::size_t N>
bool ItdSplineReader::read_header(Header<N>& header) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
  for (auto& count : header.raw.num_control)
    if (!read_count("a number of control points", 1, kMost, count)) return false;
  header.orders = header.raw.num_control;
  if (header.basis == Basis::kBspline)
    for (auto& order : header.orders)
      if (!read_count("an order", 1, kMost, order)) return false;
  return read_point_type(header.raw.num_components, header.raw.is_rational);
}

template <std::size_t N>
bool ItdSplineReader::read_knots(Header<N>& header) {
  for (std::size_t a = 0; a < N; ++a) {
    if (!take_bracket('[')) return false;
    const std::string_view word = peek();
    const bool is_periodic = word == "KVP";
    if (!is_periodic && word != "KV") return fail_expected("KV or KVP");
    p_ += word.size();
    const std::uint64_t order = header.orders[a];
    const std::uint64_t count = header.raw.num_control[a] + order + (is_periodic ? order - 1 : 0);
    if (!check_announced(count, "knots")) return false;
    header.raw.is_periodic[a] = is_periodic;
    auto& knots = header.raw.knots[a];
    for (knots.reserve(count); knots.size() < count;) {
      if (at(']'))
        return fail(p_, Code::kBadSpline,
                    std::to_string(knots.size()) + " knots instead of " + std::to_string(count) +
                        " for " + std::to_string(header.raw.num_control[a]) +
                        " control points of order " + std::to_string(order));
      knots.emplace_back();
      if (!read_number(knots.back())) return false;
    }
    if (!take_bracket(']')) return false;
  }
  return true;
}

template <std::size_t N>
bool ItdSplineReader::read_points(RawSpline<N>& raw) {
  std::uint64_t total = 0;
  const auto components = static_cast<std::uint64_t>(raw.num_components);
  if (!check_grid(raw.num_control, components, total)) return false;
  raw.points.resize(total);
  for (std::uint64_t i = 0; i < total; i += components) {
    if (!take_bracket('[')) return false;
    // IRIT lists the weight first.
    for (std::uint64_t c = 0; c < components; ++c) {
      const std::uint64_t to = !raw.is_rational ? c : c == 0 ? components - 1 : c - 1;
      if (!read_number(raw.points[i + to])) return false;
    }
    if (!take_bracket(']')) return false;
  }
  return true;
}

template <std::size_t N>
bool ItdSplineReader::read_body(const char* open, Header<N>& header,
                                std::optional<BSpline<Rational, N>>& spline) {
  RawSpline<N>& raw = header.raw;
  for (std::size_t a = 0; a < N; ++a) {
    if (header.orders[a] > raw.num_control[a])
      return fail(open, Code::kBadSpline,
                  "the order " + std::to_string(header.orders[a]) +
                      " is larger than the number of control points, " +
                      std::to_string(raw.num_control[a]));
    if (header.orders[a] > kMaxSplineDegree + 1)
      return fail(open, Code::kOverLimit,
                  "the degree " + std::to_string(header.orders[a] - 1) + " is over the limit " +
                      std::to_string(kMaxSplineDegree));
    raw.degrees[a] = static_cast<int>(header.orders[a]) - 1;
    if (header.basis != Basis::kBspline) raw.knots[a] = bezier_knots(raw.degrees[a]);
  }
  if (header.basis == Basis::kBspline && !read_knots(header)) return false;
  if (!read_points(raw) || !take_bracket(']')) return false;
  if (header.basis == Basis::kPower && !power_to_bernstein(raw, budget_))
    return fail(open, Code::kOverLimit, budget_.message() + ", in Bernstein's basis");
  spline = build(open, std::move(raw));
  return spline.has_value();
}

template <std::size_t N>
bool ItdSplineReader::read_spline(const char* open, std::optional<BSpline<Rational, N>>& spline,
                                  std::vector<std::string>& attributes) {
  Header<N> header;
  return read_basis(header.basis, attributes) && read_header(header) &&
         read_body(open, header, spline);
}

template <std::size_t N>
bool ItdSplineReader::read_inner(const char* keyword, std::optional<BSpline<Rational, N>>& spline) {
  skip();
  const char* const open = p_;
  std::vector<std::string> attributes;
  if (!open_keyword(keyword) || !read_spline(open, spline, attributes)) return false;
  drop_attributes(attributes);
  return true;
}

template <std::size_t N>
bool ItdSplineReader::read_multivariate_of(const char* open, Basis basis, SplineEntity& entity) {
  Header<N> header;
  header.basis = basis;
  std::optional<BSpline<Rational, N>> spline;
  if (!read_header(header) || !read_body(open, header, spline)) return false;
  entity.shape = std::move(*spline);
  return true;
}

bool ItdSplineReader::read_multivariate(const char* open, SplineEntity& entity, bool& is_known) {
  Basis basis{};
  if (!read_basis(basis, entity.attributes)) return false;
  std::uint64_t dimension = 0;
  if (!read_count("a number of parameters", 1, 1000, dimension)) return false;
  is_known = dimension <= 3;
  if (dimension == 1) return read_multivariate_of<1>(open, basis, entity);
  if (dimension == 2) return read_multivariate_of<2>(open, basis, entity);
  if (dimension == 3) return read_multivariate_of<3>(open, basis, entity);
  leave_out("multivariates of " + std::to_string(dimension) + " parameters", "at most 3 are known",
            true);
  return skip_brackets();
}

using Texts = std::vector<std::string>;
template bool ItdSplineReader::read_spline(const char*, std::optional<ExactCurve>&, Texts&);
template bool ItdSplineReader::read_spline(const char*, std::optional<ExactSurface>&, Texts&);
template bool ItdSplineReader::read_spline(const char*, std::optional<ExactVolume>&, Texts&);
template bool ItdSplineReader::read_inner(const char*, std::optional<ExactCurve>&);
template bool ItdSplineReader::read_inner(const char*, std::optional<ExactSurface>&);

}  // namespace veritope
