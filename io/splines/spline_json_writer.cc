// SPDX-License-Identifier: LGPL-3.0-or-later
// Our exact text form: docs/formats/spline-json.md. One point a line; numbers in lowest terms.
#include "io/base/json_string.h"
#include "io/splines/write_splines.h"

namespace veritope {
namespace {

class JsonWriter {
 public:
  std::string write(const SplineModel& model) {
    out_ = "{\"format\": \"veritope-spline-1\",\n\"groups\": ";
    list(model.groups, [&](const SplineGroup& g) { group(g); });
    out_ += ",\n\"entities\": ";
    list(model.entities, [&](const SplineEntity& e) { entity(e); });
    return std::move(out_ += "}\n");
  }

 private:
  void text(std::string_view s) { append_json_string(s, out_); }
  template <typename List, typename Item>
  void list(const List& items, Item item, const char* separator = ",\n ") {
    out_ += '[';
    bool is_first = true;
    for (const auto& i : items) {
      if (!is_first) out_ += separator;
      is_first = false;
      item(i);
    }
    out_ += ']';
  }
  void number(const Rational& r) { out_ += '"' + r.to_string() + '"'; }
  void texts(const std::vector<std::string>& items) {
    list(
        items, [&](const std::string& s) { text(s); }, ", ");
  }
  void index(const std::optional<std::size_t>& i) { out_ += i ? std::to_string(*i) : "null"; }

  void group(const SplineGroup& g) {
    out_ += "{\"name\": ";
    text(g.name);
    out_ += ", \"parent\": ";
    index(g.parent);
    out_ += ", \"attributes\": ";
    texts(g.attributes);
    out_ += '}';
  }
  template <std::size_t N>
  void map(const BSpline<Rational, N>& s) {
    using Axis = KnotAxis<Rational>;
    out_ += "{\"degrees\": ";
    list(
        s.axes(), [&](const Axis& a) { out_ += std::to_string(a.degree); }, ", ");
    out_ += ", \"periodic\": ";
    list(
        s.axes(), [&](const Axis& a) { out_ += a.is_periodic ? "true" : "false"; }, ", ");
    out_ += ",\n  \"knots\": ";
    list(
        s.axes(),
        [&](const Axis& a) {
          list(
              a.knots, [&](const Rational& k) { number(k); }, ", ");
        },
        ",\n   ");
    out_ += ",\n  ";
    points(s, s.grid().count());
  }
  // Writes what maps of axes and triangles have in common.
  template <typename Map>
  void points(const Map& s, std::size_t count) {
    out_ += std::string("\"rational\": ") + (s.is_rational() ? "true" : "false") +
            ", \"components\": " + std::to_string(s.num_components()) + ",\n  \"points\": [";
    for (std::size_t i = 0; i < count; ++i) {
      out_ += i == 0 ? "[" : ",\n   [";
      for (int c = 0; c < s.num_components(); ++c) {
        if (c != 0) out_ += ", ";
        number(s.component(c)[i]);
      }
      out_ += ']';
    }
    out_ += "]}";
  }
  void optional_map(const std::optional<ExactCurve>& curve) {
    if (curve) {
      map(*curve);
    } else {
      out_ += "null";
    }
  }
  void space(const std::optional<ExactCurve>& curve) {
    out_ += ", \"space\": ";
    optional_map(curve);
  }
  // Writes an object's map and the beginning of the list of its loops.
  template <typename Surface>
  void map_and_loops(const Surface& s, const char* blanks) {
    out_ += "{\"map\": ";
    map(s.surface);
    out_ += std::string(",\n") + blanks + "\"loops\": ";
  }
  void shape(const ExactCurve& s) { map(s); }
  void shape(const ExactSurface& s) { map(s); }
  void shape(const ExactVolume& s) { map(s); }
  // A triangle is stored in the order that the format has.
  void shape(const ExactTriangle& t) {
    out_ += "{\"degree\": " + std::to_string(t.degree()) + ", ";
    points(t, t.count());
  }
  void shape(const TrimmedSurface& s) {
    map_and_loops(s, " ");
    list(s.loops, [&](const TrimLoop& loop) {
      list(loop, [&](const TrimCurve& piece) {
        out_ += "{\"parameter\": ";
        optional_map(piece.parameter);
        space(piece.space);
        out_ += ", \"omitted\": ";
        text(piece.omitted);
        out_ += '}';
      });
    });
    out_ += '}';
  }
  void shape(const SplineBrep& brep) {
    out_ += "{\"surfaces\": ";
    list(brep.faces, [&](const BrepFace& face) {
      map_and_loops(face, "  ");
      list(
          face.loops,
          [&](const std::vector<std::int64_t>& loop) {
            list(
                loop, [&](std::int64_t n) { out_ += std::to_string(n); }, ", ");
          },
          ", ");
      out_ += '}';
    });
    out_ += ",\n \"segments\": ";
    list(brep.segments, [&](const BrepSegment& s) {
      out_ += "{\"surfaces\": [" + std::to_string(s.faces[0]) + ", " + std::to_string(s.faces[1]) +
              "], \"parameter\": ";
      list(s.parameter, [&](const std::optional<ExactCurve>& c) { optional_map(c); });
      space(s.space);
      out_ += '}';
    });
    out_ += '}';
  }
  void entity(const SplineEntity& e) {
    out_ += "{\"kind\": ";
    text(spline_kind_name(e));
    out_ += ", \"group\": ";
    index(e.group);
    out_ += ", \"attributes\": ";
    texts(e.attributes);
    out_ += ",\n \"shape\": ";
    std::visit([&](const auto& s) { shape(s); }, e.shape);
    out_ += '}';
  }

  std::string out_;
};

}  // namespace

std::string spline_json_bytes(const SplineModel& model) { return JsonWriter().write(model); }

}  // namespace veritope
