// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_defects.h"

#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_boundaries.h"
#include "solids/dms/dms_domain.h"
#include "solids/dms/dms_exact_knots_internal.h"

namespace veritope {
namespace {

class DmsDefectSearch {
 public:
  DmsDefectSearch(const DmsModel& model, std::size_t max_listed)
      : model_(model),
        max_listed_(max_listed),
        knots_(model),
        complex_(model.tetrahedra, static_cast<std::uint32_t>(model.clouds.size())),
        is_degenerate_(model.tetrahedra.size()) {}

  DmsDefects run() {
    search_tetrahedra();
    const bool has_boundary = out_.count == 0;
    if (has_boundary) search_domain();
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t) search_clouds(t);
    search_cores();
    if (has_boundary) search_hulls();
    return std::move(out_);
  }

 private:
  void add(DmsDefect defect) {
    if (out_.count++ < max_listed_) out_.first.push_back(std::move(defect));
  }
  static DmsDefect defect_of(DmsFault fault, std::vector<std::uint32_t> tetrahedra) {
    DmsDefect out;
    out.fault = fault;
    out.tetrahedra = std::move(tetrahedra);
    return out;
  }
  static std::vector<std::uint32_t> tetrahedra_of(const std::vector<TetrahedronFace>& faces) {
    std::vector<std::uint32_t> out;
    for (const TetrahedronFace f : faces)
      if (out.empty() || out.back() != face_tetrahedron(f)) out.push_back(face_tetrahedron(f));
    return out;
  }
  Sign orientation(std::uint32_t t, const TetrahedralIndex& gamma) const {
    const TetrahedronCorners& v = model_.tetrahedra[t];
    return orient3d(knots_.at(v[0], gamma[0]), knots_.at(v[1], gamma[1]), knots_.at(v[2], gamma[2]),
                    knots_.at(v[3], gamma[3]));
  }

  void search_tetrahedra() {
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t)
      if (const Sign s = orientation(t, {}); s != Sign::kPositive) {
        is_degenerate_[t] = true;
        DmsDefect defect = defect_of(DmsFault::kReversed, {t});
        defect.sign = s;
        add(std::move(defect));
      }
    for (const FaceOveruse& over : complex_.overused()) {
      std::vector<std::uint32_t> all;
      for (const TetrahedronFace f : over.faces) all.push_back(face_tetrahedron(f));
      DmsDefect defect = defect_of(DmsFault::kOverused, std::move(all));
      defect.vertices.assign(over.vertices.begin(), over.vertices.end());
      defect.faces = over.faces;
      add(std::move(defect));
    }
  }

  void search_domain() {
    DmsDomainDefects found = find_domain_defects(model_, complex_);
    for (DmsCrowdedEdge& edge : found.crowded) {
      DmsDefect defect = defect_of(DmsFault::kCrowdedEdge, tetrahedra_of(edge.faces));
      defect.vertices.assign(edge.vertices.begin(), edge.vertices.end());
      defect.faces = std::move(edge.faces);
      add(std::move(defect));
    }
    for (const DmsPinchedVertex& pinched : found.pinched) {
      const auto all = complex_.tetrahedra_at(pinched.vertex);
      DmsDefect defect = defect_of(DmsFault::kPinched, {all.begin(), all.end()});
      defect.vertices = {pinched.vertex};
      add(std::move(defect));
    }
    for (DmsImproperFaces& pair : found.improper) {
      DmsDefect defect = defect_of(
          DmsFault::kImproper, {face_tetrahedron(pair.faces[0]), face_tetrahedron(pair.faces[1])});
      defect.faces.assign(pair.faces.begin(), pair.faces.end());
      for (auto& weights : pair.weights)
        for (Rational& w : weights) defect.shares.push_back(std::move(w));
      defect.point = std::move(pair.point);
      add(std::move(defect));
    }
    for (DmsOverlap& overlap : found.overlaps) {
      DmsDefect defect =
          defect_of(DmsFault::kOverlap, {overlap.tetrahedra.begin(), overlap.tetrahedra.end()});
      defect.point = std::move(overlap.point);
      add(std::move(defect));
    }
  }

  void search_clouds(std::uint32_t t) {
    const TetrahedronCorners& v = model_.tetrahedra[t];
    for (int sum = 1; sum <= model_.condition_degree(); ++sum)
      for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& gamma) {
        for (std::size_t m = 0; m < 4; ++m)
          if (!knots_.has(v[m], gamma[m])) return;
        const Sign s = orientation(t, gamma);
        if (s == Sign::kPositive) return;
        is_degenerate_[t] = true;
        DmsDefect defect = defect_of(DmsFault::kDegenerate, {t});
        defect.beta = gamma;
        defect.sign = s;
        add(std::move(defect));
      });
  }
  void search_cores() {
    for (DmsNoCore& none : find_missing_cores(model_, is_degenerate_)) {
      DmsDefect defect = defect_of(DmsFault::kNoCore, {none.tetrahedron});
      for (const DmsCoreWeight& w : none.weights)
        if (defect.beta == TetrahedralIndex{}) defect.beta = w.gamma;
      defect.weights = std::move(none.weights);
      add(std::move(defect));
    }
  }
  void search_hulls() {
    for (DmsHullInside& hull : find_hulls_inside(model_, complex_)) {
      DmsDefect defect =
          defect_of(DmsFault::kInside, {face_tetrahedron(hull.face), hull.tetrahedron});
      for (std::size_t i = 0; i < 3; ++i)
        defect.beta[kTetrahedronFaces[face_corner(hull.face)][i]] = hull.last[i];
      defect.faces = {hull.face};
      defect.shares = std::move(hull.common.shares);
      defect.point = std::move(hull.common.point);
      add(std::move(defect));
    }
  }

  const DmsModel& model_;
  const std::size_t max_listed_;
  const internal::DmsExactKnots knots_;
  const TetrahedralComplex complex_;
  std::vector<bool> is_degenerate_;  // some d(W_γ) <= 0
  DmsDefects out_;
};

template <typename List>
std::string list_text(const List& numbers) {
  std::string out;
  for (const std::uint32_t n : numbers) out += (out.empty() ? "" : ", ") + std::to_string(n);
  return out;
}
std::string point_text(const DmsPoint& p) {
  return "(" + p[0].to_string() + ", " + p[1].to_string() + ", " + p[2].to_string() + ")";
}
std::string overused_text(const DmsDefect& defect) {
  return "the vertices " + list_text(defect.vertices) + " are a face of the tetrahedra " +
         list_text(defect.tetrahedra) +
         (defect.tetrahedra.size() == 2 ? " in one orientation" : "");
}
std::string no_core_text(const DmsDefect& defect) {
  std::string list;
  for (const DmsCoreWeight& w : defect.weights)
    list += (list.empty() ? "" : ", ") + to_string(w.gamma);
  return "tetrahedron " + list_text(defect.tetrahedra) +
         ": the knots' tetrahedra of beta = " + list + " have no common inner point";
}

}  // namespace

const char* fault_name(DmsFault fault) {
  switch (fault) {
    case DmsFault::kReversed: return "tet-reversed";
    case DmsFault::kOverused: return "tet-face-overused";
    case DmsFault::kCrowdedEdge: return "M4";
    case DmsFault::kPinched: return "M6";
    case DmsFault::kImproper: return "M7";
    case DmsFault::kOverlap: return "M9";
    case DmsFault::kDegenerate: return "cloud-degenerate";
    case DmsFault::kNoCore: return "cloud-no-core";
    case DmsFault::kInside: return "cloud-inside";
    case DmsFault::kDomainsDiffer: return "domains-differ";
  }
  VT_CHECK(false, "a fault has a name");
  return "";
}

namespace {

std::string text_within(const DmsDefect& defect) {
  const std::string sign = defect.sign == Sign::kZero ? "d = 0" : "d < 0";
  const std::string tetrahedra = list_text(defect.tetrahedra);
  switch (defect.fault) {
    case DmsFault::kReversed: return "tetrahedron " + tetrahedra + ": " + sign;
    case DmsFault::kOverused: return overused_text(defect);
    case DmsFault::kCrowdedEdge:
      return "the edge of the vertices " + list_text(defect.vertices) + " is in " +
             std::to_string(defect.faces.size()) + " faces of the domain's boundary";
    case DmsFault::kPinched:
      return "the faces of the domain's boundary at vertex " + list_text(defect.vertices) +
             " form several fans";
    case DmsFault::kImproper:
      return "faces of the domain's boundary, of the tetrahedra " + tetrahedra + ", meet at " +
             point_text(*defect.point);
    case DmsFault::kOverlap:
      return "the tetrahedra " + tetrahedra + " overlap at " + point_text(*defect.point);
    case DmsFault::kDegenerate:
      return "tetrahedron " + tetrahedra + ", beta " + to_string(defect.beta) + ": " + sign;
    case DmsFault::kNoCore: return no_core_text(defect);
    case DmsFault::kInside:
      return "tetrahedron " + std::to_string(defect.tetrahedra[0]) + ", beta " +
             to_string(defect.beta) +
             ": the hull of these knots of a face of the boundary reaches into tetrahedron " +
             std::to_string(defect.tetrahedra[1]) + " at " + point_text(*defect.point);
    case DmsFault::kDomainsDiffer:
      return "the point " + point_text(*defect.point) + " is in a face of the boundary of " +
             (defect.is_of_attributes ? "the attribute domain" : "the domain") +
             ", of tetrahedron " + tetrahedra + ", and not on the boundary of " +
             (defect.is_of_attributes ? "the domain" : "the attribute domain");
  }
  return "";
}

void add_defects_of_attributes(const DmsModel& model, const DmsModel& own, std::size_t max_listed,
                               DmsDefects& out) {
  DmsDefects more = find_geometry_defects(own, max_listed - out.first.size());
  out.count += more.count;
  for (DmsDefect& defect : more.first) {
    defect.is_of_attributes = true;
    out.first.push_back(std::move(defect));
  }
  if (out.count > 0) return;
  auto difference = find_boundary_difference(model, own);
  if (!difference) return;
  ++out.count;
  if (max_listed == 0) return;
  DmsDefect& defect = out.first.emplace_back();
  defect.fault = DmsFault::kDomainsDiffer;
  defect.is_of_attributes = difference->is_of_second;
  defect.tetrahedra = {face_tetrahedron(difference->face)};
  defect.faces = {difference->face};
  defect.point = std::move(difference->point);
}

}  // namespace

std::string to_string(const DmsDefect& defect) {
  const bool is_named = defect.is_of_attributes && defect.fault != DmsFault::kDomainsDiffer;
  return (is_named ? "attribute domain: " : "") + text_within(defect);
}

DmsDefects find_geometry_defects(const DmsModel& model, std::size_t max_listed) {
  return DmsDefectSearch(model, max_listed).run();
}

DmsDefects find_attribute_defects(const DmsModel& model, std::size_t max_listed) {
  DmsDefects out;
  for (const DmsModel& own : model.attribute_domain)
    add_defects_of_attributes(model, own, max_listed, out);
  return out;
}

DmsDefects find_dms_defects(const DmsModel& model, std::size_t max_listed) {
  DmsDefects out = find_geometry_defects(model, max_listed);
  for (const DmsModel& own : model.attribute_domain)
    add_defects_of_attributes(model, own, max_listed, out);
  return out;
}

}  // namespace veritope
