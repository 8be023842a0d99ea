// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_invalid.cc: the conditions of docs/certificates/dms-invalid.md in their order.
#include "dms_invalid.h"

#include "dms_claim.h"

namespace {

const char* const kDmsFindings[] = {"tet-reversed",
                                    "tet-face-overused",
                                    "cloud-degenerate",
                                    "cloud-no-core",
                                    "cloud-inside",
                                    "jacobian",
                                    "jacobian-zero",
                                    "M4",
                                    "M6",
                                    "M7",
                                    "M9",
                                    "meeting",
                                    "crossing",
                                    "covering"};

}  // namespace

void check_dms_finding(const Statement& s) {
  const std::string& finding = s.text.at("finding");
  require(std::find(std::begin(kDmsFindings), std::end(kDmsFindings), finding) !=
              std::end(kDmsFindings),
          "S1", "unknown finding");
}

std::string check_dms_invalid(const Statement& s, std::string model_text, const Body& bytes) {
  const DmsFile file = read_dms(model_text);
  model_text = std::string();
  DmsModel model(file);
  find_dms_boundary(&model);
  const DmsFinding f = read_dms_finding(model, bytes);
  require(s.text.at("finding") == kDmsFindings[f.kind], "B3", "the body has another finding");
  require(s.number.at("tetrahedra") == file.tetrahedra.size(), "B3", "the number of tetrahedra is",
          file.tetrahedra.size());
  Units units = dms_units(s.number.at("subject_bytes") + bytes.left());
  if (f.needs_map()) {
    check_dms_domain(model);
    check_dms_clouds(model, f.boundary, &units);
    if (f.kind == kImagesCross)
      check_dms_crossing(model, f, &units);
    else
      check_dms_map(model, f, &units);
  } else if (f.kind >= kEdgeOverused && f.kind <= kFacesMeet) {
    check_dms_surface_of_domain(model, f);
  } else {
    check_dms_tetrahedra(model, f);
  }
  return s.text.at("finding") + ", " + std::to_string(file.tetrahedra.size()) + " tetrahedra";
}
