// SPDX-License-Identifier: LGPL-3.0-or-later
// IRIT's .itd. Bezier splines are written as BSPLINE, so that reading gives the same knots; periodic axes as KVP. The
// format has no Bezier triangles: they are left out.
#include <algorithm>

#include "io/base/scan.h"
#include "io/splines/write_splines.h"

namespace veritope {
namespace {

constexpr int kMostCoordinates = 9;  // E1..E9, P1..P9

template <std::size_t N>
bool has_type(const BSpline<Rational, N>& s) {
  return s.dimension() >= 1 && s.dimension() <= kMostCoordinates;
}

class ItdWriter {
 public:
  explicit ItdWriter(const ReadLimits& limits) : limits_(limits) {}
  std::string write(const SplineModel& model) {
    for (const SplineEntity& e : model.entities) {
      bool fits = !std::holds_alternative<ExactTriangle>(e.shape);
      for_each_spline(e, [&](const auto& s) { fits = fits && has_type(s); });
      if (const auto* t = std::get_if<TrimmedSurface>(&e.shape))
        for (const TrimLoop& loop : t->loops)
          for (const TrimCurve& piece : loop) fits = fits && piece.parameter.has_value();
      if (!fits) continue;
      go_to(model, e.group);
      line("");
      std::visit([&](const auto& s) { shape(s, e.attributes); }, e.shape);
    }
    while (!path_.empty()) close();
    return std::move(out_);
  }

 private:
  std::string number(const Rational& x) const { return decimal_or_nearest(x, limits_); }
  void line(const std::string& text) {
    out_ += std::string(2 * path_.size() + 2 * depth_, ' ') + text;
  }
  void close() {
    path_.pop_back();
    line("]\n");
  }
  void open(const SplineGroup& g) {
    line("[OBJECT");
    for (const std::string& a : g.attributes)
      if (is_itd_attribute(a)) out_ += " [" + a + "]";
    if (!g.name.empty() && is_itd_name(g.name)) out_ += " " + g.name;
    out_ += '\n';
  }
  // Closes and opens objects until the innermost open one is `group`.
  void go_to(const SplineModel& model, std::optional<std::size_t> group) {
    std::vector<std::size_t> wanted;
    for (auto g = group; g; g = model.groups[*g].parent) wanted.push_back(*g);
    std::reverse(wanted.begin(), wanted.end());
    std::size_t common = 0;
    while (common < path_.size() && common < wanted.size() && path_[common] == wanted[common])
      ++common;
    while (path_.size() > common) close();
    for (; common < wanted.size(); ++common) {
      open(model.groups[wanted[common]]);
      path_.push_back(wanted[common]);
    }
  }

  template <std::size_t N>
  void spline(const BSpline<Rational, N>& s, const std::vector<std::string>& attributes) {
    constexpr const char* kKeywords[] = {"CURVE", "SURFACE", "TRIVAR"};
    out_ += std::string("[") + kKeywords[N - 1] + " BSPLINE";
    for (const std::string& a : attributes)
      if (is_itd_attribute(a)) out_ += " [" + a + "]";
    std::array<std::size_t, N> counts;
    for (std::size_t a = 0; a < N; ++a) {
      counts[a] = s.axis(a).num_control();
      if (s.axis(a).is_periodic) counts[a] -= static_cast<std::size_t>(s.axis(a).degree);
      out_ += ' ' + std::to_string(counts[a]);
    }
    for (std::size_t a = 0; a < N; ++a) out_ += ' ' + std::to_string(s.axis(a).degree + 1);
    out_ += std::string(s.is_rational() ? " P" : " E") + std::to_string(s.dimension()) + '\n';
    ++depth_;
    for (const auto& axis : s.axes()) {
      line(axis.is_periodic ? "[KVP" : "[KV");
      for (const Rational& k : axis.knots) out_ += ' ' + number(k);
      out_ += "]\n";
    }
    points(s, counts);
    --depth_;
    line("]\n");
  }
  template <std::size_t N>
  void points(const BSpline<Rational, N>& s, const std::array<std::size_t, N>& counts) {
    const Grid<N> grid = s.grid();
    std::size_t total = 1;
    for (const std::size_t c : counts) total *= c;
    for (std::size_t i = 0; i < total; ++i) {
      std::array<std::size_t, N> index;
      std::size_t rest = i;
      for (std::size_t a = 0; a < N; rest /= counts[a], ++a) index[a] = rest % counts[a];
      const std::size_t at = grid.at(index);
      line("[");
      if (s.is_rational()) out_ += number(s.component(s.dimension())[at]) + ' ';
      for (int c = 0; c < s.dimension(); ++c)
        out_ += (c == 0 ? "" : " ") + number(s.component(c)[at]);
      out_ += "]\n";
    }
  }

  void shape(const ExactTriangle&, const std::vector<std::string>&) {}
  void shape(const ExactCurve& s, const std::vector<std::string>& a) { spline(s, a); }
  void shape(const ExactSurface& s, const std::vector<std::string>& a) { spline(s, a); }
  void shape(const ExactVolume& s, const std::vector<std::string>& a) { spline(s, a); }
  void shape(const TrimmedSurface& s, const std::vector<std::string>& attributes) {
    out_ += "[TRIMSRF";
    for (const std::string& a : attributes)
      if (is_itd_attribute(a)) out_ += " [" + a + "]";
    out_ += '\n';
    ++depth_;
    line("");
    spline(s.surface, {});
    for (const TrimLoop& loop : s.loops) {
      line("[TRIMCRV\n");
      ++depth_;
      for (const TrimCurve& piece : loop) {
        line("[TRIMCRVSEG\n");
        ++depth_;
        line("");
        spline(*piece.parameter, {});
        if (piece.space) line(""), spline(*piece.space, {});
        --depth_;
        line("]\n");
      }
      --depth_;
      line("]\n");
    }
    --depth_;
    line("]\n");
  }
  void shape(const SplineBrep& brep, const std::vector<std::string>& attributes) {
    out_ += "[MODEL";
    for (const std::string& a : attributes)
      if (is_itd_attribute(a)) out_ += " [" + a + "]";
    out_ +=
        ' ' + std::to_string(brep.faces.size()) + ' ' + std::to_string(brep.segments.size()) + '\n';
    ++depth_;
    for (const BrepFace& face : brep.faces) {
      line("[MDLTSRF " + std::to_string(face.loops.size()) + "\n");
      ++depth_;
      line("");
      spline(face.surface, {});
      for (const auto& loop : face.loops) {
        line("[MDLLOOP");
        for (const std::int64_t n : loop) out_ += ' ' + std::to_string(n);
        out_ += "]\n";
      }
      --depth_;
      line("]\n");
    }
    for (const BrepSegment& s : brep.segments) segment(s);
    --depth_;
    line("]\n");
  }
  void segment(const BrepSegment& s) {
    const int mask = (s.parameter[0] ? 1 : 0) + (s.parameter[1] ? 2 : 0) + (s.space ? 4 : 0);
    line("[MDLTSEG " + std::to_string(mask) + ' ' + std::to_string(s.faces[0]) + ' ' +
         std::to_string(s.faces[1]) + '\n');
    ++depth_;
    for (const auto* curve : {&s.parameter[0], &s.parameter[1], &s.space})
      if (*curve) line(""), spline(**curve, {});
    --depth_;
    line("]\n");
  }

  const ReadLimits& limits_;
  std::string out_;
  std::vector<std::size_t> path_;  // the open groups
  std::size_t depth_ = 0;          // depth of brackets within the entity
};

}  // namespace

bool is_itd_name(const std::string& name) {
  return !name.empty() && std::none_of(name.begin(), name.end(), [](char c) {
    return has_class(c, kTokenEnd) || c == '[' || c == ']' || c == '"';
  });
}

bool is_itd_attribute(const std::string& text) {
  if (text.empty() || has_class(text.front(), kTokenEnd) || has_class(text.back(), kTokenEnd))
    return false;
  if (text.front() == '[' || text.front() == ']' || text.front() == '"') return false;
  constexpr const char* kTaken[] = {"KV",         "KVP",      "OBJECT",   "CURVE",     "SURFACE",
                                    "TRIVAR",     "TRIMSRF",  "TRIMCRV",  "MODEL",     "MULTIVAR",
                                    "TRIMCRVSEG", "POLYGON",  "POLYLINE", "POINTLIST", "POLYSTRIP",
                                    "TRISRF",     "INSTANCE", "NUMBER",   "STRING",    "POINT",
                                    "VECTOR",     "PLANE",    "MATRIX",   "CTLPT"};
  std::size_t end = 0;
  while (end < text.size() && !has_class(text[end], kTokenEnd) && text[end] != '[' &&
         text[end] != ']' && text[end] != '"')
    ++end;
  const std::string_view word = std::string_view(text).substr(0, end);
  for (const char* taken : kTaken)
    if (word == taken) return false;
  std::int64_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      for (++i; i < text.size() && text[i] != '"'; ++i)
        if (text[i] == '\\') ++i;
      if (i >= text.size()) return false;
    }
    depth += text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
    if (depth < 0) return false;
  }
  return depth == 0;
}

std::string itd_bytes(const SplineModel& model, const ReadLimits& limits) {
  return ItdWriter(limits).write(model);
}

}  // namespace veritope
