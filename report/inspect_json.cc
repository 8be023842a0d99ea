// SPDX-License-Identifier: LGPL-3.0-or-later
// The JSON of veritope inspect. Elements are written one by one: a large model has a million of them.
#include <algorithm>
#include <utility>

#include "report/decimal_text.h"
#include "report/inspect_report.h"
#include "report/json_text.h"
#include "solids/vmodel/v_parts.h"
#include "topology/v_complex_links.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

template <class Id>
Json ids_json(const std::vector<Id>& ids) {
  Json out = Json::array();
  for (const Id id : ids) out.push_back(id.value);
  return out;
}
template <class Id>
std::vector<Id> ascending(std::vector<Id> ids) {
  std::sort(ids.begin(), ids.end());
  return ids;
}
Json part_json(std::uint64_t cell, std::string part) {
  return {{"cell", cell}, {"part", std::move(part)}};
}

// A part of a cell that belongs to an element.
struct CellPart {
  std::uint32_t cell, part;
};
using PartLists = std::vector<std::vector<CellPart>>;

// "NAME":[, then elements each on a line.
class ListWriter {
 public:
  ListWriter(std::string& out, const char* name) : out_(out) {
    out_ += std::string(",\n\"") + name + "\":[";
  }
  void add(const Json& element) {
    out_ += is_empty_ ? "\n" : ",\n";
    out_ += dump(element);
    is_empty_ = false;
  }
  ~ListWriter() { out_ += is_empty_ ? "]" : "\n]"; }
  ListWriter(const ListWriter&) = delete;
  ListWriter& operator=(const ListWriter&) = delete;

 private:
  std::string& out_;
  bool is_empty_ = true;
};

class InspectJson {
 public:
  explicit InspectJson(const InspectReport& report)
      : report_(report), elements_(report.elements), complex_(report.elements.complex) {
    const VComplexTables& t = complex_.tables();
    faces_.resize(t.surfaces.end_id());
    edges_.resize(t.curves.end_id());
    corners_.resize(t.points.end_id());
    for (std::uint32_t c = 0; c < report.model.num_cells(); ++c) {
      for (std::uint32_t k = 0; k < 6; ++k)
        if (const HalfVSurfaceId h = elements_.half_surfaces[c][k]; !h.is_none())
          faces_[complex_.half_surface(h).surface.value].push_back({c, k});
      for (std::uint32_t e = 0; e < 12; ++e)
        if (const VCurveId curve = elements_.curves[c][e]; !curve.is_none())
          edges_[curve.value].push_back({c, e});
      for (std::uint32_t i = 0; i < 8; ++i)
        corners_[elements_.points[c][i].value].push_back({c, i});
    }
  }

  std::string text() {
    out_ = "{\"schema\":\"veritope-inspect-1\",\"tool\":" + dump(Json(tool_name())) +
           ",\n\"counts\":" + dump(counts());
    cells();
    surfaces();
    curves();
    points();
    collapsed();
    out_ += ",\n\"betti\":" + dump(optional_json(report_.betti)) +
            ",\"components\":" + std::to_string(report_.components) +
            ",\"manifold\":" + (report_.is_manifold() ? "true" : "false") + "}\n";
    return std::move(out_);
  }

 private:
  Json counts() const {
    const VComplexCounts n = complex_.counts();
    Json out;
    out["cells"] = n.cells;
    out["pieces"] = report_.model.num_pieces();
    out["half_v_surfaces"] = n.half_surfaces;
    out["v_surfaces"] = n.surfaces;
    out["internal"] = n.internal_surfaces;
    out["boundary"] = n.surfaces - n.internal_surfaces;
    out["v_curves"] = n.curves;
    out["v_points"] = n.points;
    out["euler"] = static_cast<std::int64_t>(n.points) - static_cast<std::int64_t>(n.curves) +
                   static_cast<std::int64_t>(n.surfaces) - static_cast<std::int64_t>(n.cells);
    out["bodies"] = nullptr;  // nothing is certified
    out["boxes"] = nullptr;
    return out;
  }

  void cells() {
    ListWriter list(out_, "cells");
    for (std::uint32_t c = 0; c < report_.model.num_cells(); ++c) {
      Json faces;
      for (std::size_t k = 0; k < 6; ++k) {
        const HalfVSurfaceId h = elements_.half_surfaces[c][k];
        faces[v_face_name(k)] =
            h.is_none() ? Json(nullptr) : Json(complex_.half_surface(h).surface.value);
      }
      list.add(
          {{"id", c}, {"faces", faces}, {"neighbours", ids_json(complex_.neighbours(VCellId{c}))}});
    }
  }

  void surfaces() {
    ListWriter list(out_, "v_surfaces");
    for (std::uint32_t s = 0; s < faces_.size(); ++s) {
      Json halves = Json::array();
      for (const CellPart& f : faces_[s]) halves.push_back(part_json(f.cell, v_face_name(f.part)));
      const VFaceRole& role = report_.model.face(faces_[s][0].cell, faces_[s][0].part);
      list.add({{"id", s},
                {"halves", halves},
                {"symmetry", role.is_glued() ? Json(role.symmetry) : Json(nullptr)}});
    }
  }

  Json fans_json(VCurveId curve) const {
    Json out = Json::array();
    for (const VFan& fan : complex_.fans(curve)) {
      Json cells = Json::array(), surfaces = Json::array();
      for (std::size_t i = 0; i < fan.uses.size(); ++i) {
        const HalfVSurface& half = complex_.half_surface(complex_.use(fan.uses[i]).half_surface);
        if (i % 2 == 0) cells.push_back(half.cell.value);
        // Each V-surface once: with the sector after it; the last one of an open fan is after all sectors.
        if (i % 2 == 0 || (i + 1 == fan.uses.size() && !fan.is_cyclic))
          surfaces.push_back(half.surface.value);
      }
      out.push_back({{"cyclic", fan.is_cyclic}, {"cells", cells}, {"v_surfaces", surfaces}});
    }
    return out;
  }

  void curves() {
    ListWriter list(out_, "v_curves");
    for (const VCurveId c : complex_.tables().curves) {
      Json edges = Json::array();
      for (const CellPart& e : edges_[c.value])
        edges.push_back(part_json(e.cell, v_edge_name(e.part)));
      const VCurve& curve = complex_.curve(c);
      list.add({{"id", c.value},
                {"edges", edges},
                {"cells", ids_json(complex_.cells_of_curve(c))},
                {"v_surfaces", ids_json(complex_.surfaces_of_curve(c))},
                {"half_v_surfaces", complex_.half_surfaces_of_curve(c).size()},
                {"fans", fans_json(c)},
                {"points", Json::array({curve.ends[0].value, curve.ends[1].value})},
                {"boundary", link_of(complex_, c).open_fans != 0}});
    }
  }

  static const char* kind_of(const VPointLinkComponent& part) {
    return part.is_sphere() ? "sphere" : part.is_disk() ? "disk" : "other";
  }

  void points() {
    ListWriter list(out_, "v_points");
    for (const VPointId p : complex_.tables().points) {
      Json corners = Json::array(), at = Json::array(), links = Json::array();
      for (const CellPart& i : corners_[p.value])
        corners.push_back(part_json(i.cell, v_corner_name(i.part)));
      const CellPart& first = corners_[p.value][0];
      for (const Rational& x : v_corner_point(report_.model.cell(first.cell), first.part))
        at.push_back(fraction_text(x));
      bool is_on_boundary = false;
      const VPointLink link = link_of(complex_, p);
      for (const VPointLinkComponent& part : link.components) {
        is_on_boundary = is_on_boundary || part.boundary_circles != 0;
        links.push_back(
            {{"kind", kind_of(part)}, {"genus", part.genus()}, {"circles", part.boundary_circles}});
      }
      list.add({{"id", p.value},
                {"corners", corners},
                {"cells", ids_json(complex_.cells_of_point(p))},
                {"v_curves", ids_json(ascending(complex_.point(p).curves))},
                {"at", at},
                {"links", links},
                {"boundary", is_on_boundary}});
    }
  }

  void collapsed() {
    ListWriter list(out_, "collapsed");
    for (const InspectReport::Collapsed& c : report_.collapsed) {
      Json out = part_json(c.cell, c.part);
      out["onto"] = {{"kind", c.is_onto_curve ? "curve" : "point"}, {"id", c.onto}};
      list.add(out);
    }
  }

  const InspectReport& report_;
  const HexahedralVComplex& elements_;
  const VComplex& complex_;
  PartLists faces_, edges_, corners_;
  std::string out_;
};

}  // namespace

std::string inspect_json(const InspectReport& report) { return InspectJson(report).text(); }

std::string pair_json(const InspectReport& report, std::array<std::uint32_t, 2> cells) {
  const VCommon common = report.elements.complex.common(VCellId{cells[0]}, VCellId{cells[1]});
  Json out;
  out["schema"] = "veritope-inspect-pair-1";
  out["tool"] = tool_name();
  out["cells"] = cells;
  out["surfaces"] = ids_json(common.surfaces);
  out["curves"] = ids_json(common.curves);
  out["points"] = ids_json(common.points);
  out["exactly_one_point"] = common.is_exactly_one_point();
  return dump(out) + "\n";
}

}  // namespace veritope::report
