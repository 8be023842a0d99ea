// SPDX-License-Identifier: LGPL-3.0-or-later
// GoTools' .g2. The format has no groups, no periodic flag, no models and no triangles: periodic axes are written
// unclamped, the rest is left out.
#include "io/splines/write_splines.h"

namespace veritope {
namespace {

class G2Writer {
 public:
  explicit G2Writer(const ReadLimits& limits) : limits_(limits) {}
  std::string write(const SplineModel& model) {
    for (const SplineEntity& e : model.entities) {
      extra_ = " 0";
      for (const std::string& a : e.attributes)
        if (is_extra(a)) extra_ = a.substr(kExtra.size());
      std::visit([&](const auto& s) { object(s); }, e.shape);
    }
    return std::move(out_);
  }

 private:
  std::string number(const Rational& x) const { return decimal_or_nearest(x, limits_); }
  static constexpr std::string_view kExtra = "g2-extra";
  // "g2-extra 255 0 0 255" is written as a count and the numbers.
  static bool is_extra(const std::string& a) {
    if (!a.starts_with("g2-extra ") || a.size() > 200) return false;
    return a.find_first_not_of("0123456789 ", kExtra.size()) == a.npos && a.find("  ") == a.npos &&
           a.back() != ' ';
  }
  void header(int type) {
    std::size_t count = 0;
    if (extra_ != " 0")
      for (const char c : extra_) count += c == ' ' ? 1 : 0;
    out_ +=
        std::to_string(type) + " 1 0 " + std::to_string(count) + (count == 0 ? "" : extra_) + "\n";
  }
  template <std::size_t N>
  void spline(const BSpline<Rational, N>& s) {
    out_ += std::to_string(s.dimension()) + (s.is_rational() ? " 1\n" : " 0\n");
    for (const auto& axis : s.axes()) {
      out_ += std::to_string(axis.num_control()) + ' ' + std::to_string(axis.degree + 1) + '\n';
      for (const Rational& k : axis.knots) out_ += number(k) + ' ';
      out_.back() = '\n';
    }
    const Grid<N> grid = s.grid();
    for (std::size_t i = 0; i < grid.count(); ++i) {
      std::array<std::size_t, N> index;
      std::size_t rest = i;
      for (std::size_t a = 0; a < N; rest /= grid.size[a], ++a) index[a] = rest % grid.size[a];
      for (int c = 0; c < s.num_components(); ++c)
        out_ += number(s.component(c)[grid.at(index)]) + ' ';
      out_.back() = '\n';
    }
    out_ += '\n';
  }
  void object(const ExactCurve& s) {
    if (s.dimension() > 0) header(100), spline(s);
  }
  void object(const ExactSurface& s) {
    if (s.dimension() > 0) header(200), spline(s);
  }
  void object(const ExactVolume& s) {
    if (s.dimension() > 0) header(700), spline(s);
  }
  void object(const TrimmedSurface& s) {
    header(210);
    out_ += "200\n";
    spline(s.surface);
    out_ += std::to_string(s.loops.size()) + '\n';
    for (const TrimLoop& loop : s.loops) {
      out_ += std::to_string(loop.size()) + " 0\n";  // 0: we promise no tolerance
      for (const TrimCurve& piece : loop) {
        out_ += std::string(piece.parameter ? "1 100" : "0 0") + (piece.space ? " 100\n" : " 0\n");
        if (piece.parameter) spline(*piece.parameter);
        if (piece.space) spline(*piece.space);
      }
    }
  }
  void object(const SplineBrep&) {}
  void object(const ExactTriangle&) {}

  const ReadLimits& limits_;
  std::string out_, extra_;
};

}  // namespace

std::string g2_bytes(const SplineModel& model, const ReadLimits& limits) {
  return G2Writer(limits).write(model);
}

}  // namespace veritope
