// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_defects.h"

#include "predicates/exact_point.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

class DmsDefectSearch {
 public:
  DmsDefectSearch(const DmsModel& model, std::size_t max_listed)
      : model_(model), max_listed_(max_listed) {}

  DmsDefects run() {
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t)
      if (const Sign s = orientation(t, {}); s != Sign::kPositive)
        add({DmsFault::kReversed, {t}, {}, {}, s});
    const TetrahedralComplex complex(model_.tetrahedra,
                                     static_cast<std::uint32_t>(model_.clouds.size()));
    for (const FaceOveruse& over : complex.overused()) {
      DmsDefect defect{DmsFault::kOverused, {}, {}, over.vertices, {}};
      for (const TetrahedronFace f : over.faces) defect.tetrahedra.push_back(face_tetrahedron(f));
      add(std::move(defect));
    }
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t) search_clouds(t);
    return std::move(out_);
  }

 private:
  void add(DmsDefect defect) {
    if (out_.count++ < max_listed_) out_.first.push_back(std::move(defect));
  }
  Sign orientation(std::uint32_t t, const TetrahedralIndex& gamma) const {
    const TetrahedronCorners& v = model_.tetrahedra[t];
    return orient3d(
        ExactPoint3(model_.knot(v[0], gamma[0])), ExactPoint3(model_.knot(v[1], gamma[1])),
        ExactPoint3(model_.knot(v[2], gamma[2])), ExactPoint3(model_.knot(v[3], gamma[3])));
  }
  // Whether the corner's knot of this number is one of its cloud.
  bool is_new(std::uint32_t vertex, int i) const {
    return i == 0 || static_cast<std::size_t>(i) < model_.clouds[vertex].size();
  }
  void search_clouds(std::uint32_t t) {
    const TetrahedronCorners& v = model_.tetrahedra[t];
    for (int sum = 1; sum <= model_.condition_degree(); ++sum)
      for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& gamma) {
        for (std::size_t m = 0; m < 4; ++m)
          if (!is_new(v[m], gamma[m])) return;
        if (const Sign s = orientation(t, gamma); s != Sign::kPositive)
          add({DmsFault::kDegenerate, {t}, gamma, {}, s});
      });
  }

  const DmsModel& model_;
  std::size_t max_listed_;
  DmsDefects out_;
};

}  // namespace

const char* fault_name(DmsFault fault) {
  switch (fault) {
    case DmsFault::kReversed: return "tet-reversed";
    case DmsFault::kOverused: return "tet-face-overused";
    case DmsFault::kDegenerate: return "cloud-degenerate";
  }
  VT_CHECK(false, "a fault has a name");
  return "";
}

std::string to_string(const DmsDefect& defect) {
  std::string list;
  for (const std::uint32_t t : defect.tetrahedra)
    list += (list.empty() ? "" : ", ") + std::to_string(t);
  if (defect.fault == DmsFault::kOverused) {
    const auto& f = defect.face;
    return "the vertices " + std::to_string(f[0]) + ", " + std::to_string(f[1]) + ", " +
           std::to_string(f[2]) + " are a face of the tetrahedra " + list +
           (defect.tetrahedra.size() == 2 ? " in one orientation" : "");
  }
  const std::string sign = defect.sign == Sign::kZero ? "d = 0" : "d < 0";
  if (defect.fault == DmsFault::kReversed) return "tetrahedron " + list + ": " + sign;
  return "tetrahedron " + list + ", beta " + to_string(defect.beta) + ": " + sign;
}

DmsDefects find_dms_defects(const DmsModel& model, std::size_t max_listed) {
  return DmsDefectSearch(model, max_listed).run();
}

}  // namespace veritope
