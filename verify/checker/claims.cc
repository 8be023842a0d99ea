// SPDX-License-Identifier: Apache-2.0 OR MIT
// claims.cc: the table of claims. tests/claims_table_test.py compares it with the Python checker's.
#include "claims.h"

#include <algorithm>

#include "collar/collar_claim.h"
#include "dms/dms_claim.h"
#include "mesh/mesh_claims.h"
#include "micro/micro_claim.h"
#include "patches/patch_claims.h"
#include "points/points_claim.h"
#include "vmodel/vmodel_claim.h"

namespace {

const char kMeshes[] = "stl,obj,ply,off";
const char kSplines[] = "vjson,itd,g2,mfem,vjson-faces,itd-faces,g2-faces,mfem-faces";
const char kAllFormats[] =
    "stl,obj,ply,off,vjson,itd,g2,mfem,vjson-faces,itd-faces,g2-faces,mfem-faces,chain";
const char kVolumes[] = "vjson,itd,g2,mfem";
const char kStarNumbers[] =
    " bodies boxes edges flipped genus patches shells subject_bytes vertices";
const char kTurned[] =
    " bodies boxes edges flipped genus patches shells subject_bytes vertices winding";
const char kCollarNumbers[] =
    " bodies boxes cells edges flipped genus patches shells subject_bytes vertices";
const char kFindingText[] =
    " body_sha256 certificate claim finding subject_format subject_sha256 tool";
const char kStarText[] = " body_sha256 certificate claim subject_format subject_sha256 tool";

void add_keys(const std::string& names, const char* kind,
              std::map<std::string, std::string>* keys) {
  for (size_t at = 0; at < names.size();) {  // a blank precedes each name
    const size_t end = std::min(names.find(' ', at + 1), names.size());
    (*keys)[names.substr(at + 1, end - at - 1)] = kind;
    at = end;
  }
}

}  // namespace

const std::vector<Claim>& all_claims() {
  static const std::vector<Claim> claims = {
      {"mesh-valid-1", "VTMV", kMeshes,
       " body_sha256 certificate claim reading_rule subject_format subject_sha256 tool volume",
       " bodies edges faces genus shells subject_bytes vertices", " as_indexed", check_volume,
       check_mesh_valid},
      {"mesh-invalid-1", "VTMI", kMeshes,
       " body_sha256 certificate claim reading_rule rules subject_format subject_sha256 tool",
       " subject_bytes", " as_indexed", check_rules, check_mesh_invalid},
      {"mesh-reversed-1", "VTMR", kMeshes,
       " body_sha256 certificate claim reading_rule subject_format subject_sha256 tool volume",
       " bodies edges faces genus reversed reversed_shells shells subject_bytes vertices",
       " as_indexed", check_volume, check_mesh_valid},
      {"points-1", "VTPT", kAllFormats,
       " answers_sha256 body_sha256 certificate claim decimals reading_rule subject_format "
       "subject_sha256 tool",
       " answers_bytes on points subject_bytes undecided", " as_indexed winding", check_decimals,
       check_points},
      {"star-box-1", "VTSB", kSplines, kStarText, kStarNumbers, "", nullptr, check_star_box},
      {"star-box-turned-1", "VTSB", kSplines, kStarText, kTurned, "", nullptr, check_star_box},
      {"star-box-2", "VTS2", kSplines, kStarText, kStarNumbers, "", nullptr, check_star_box},
      {"star-box-turned-2", "VTS2", kSplines, kStarText, kTurned, "", nullptr, check_star_box},
      {"patch-invalid-1", "VTPI", kSplines, kFindingText,
       " flipped opposite patches same subject_bytes", "", check_finding, check_patch_invalid},
      {"patch-invalid-2", "VTI2", kSplines, kFindingText, " flipped patches subject_bytes", "",
       check_finding_2, check_patch_invalid_2},
      {"volume-folded-1", "VTVF", kVolumes, kStarText, " entity subject_bytes volumes", "", nullptr,
       check_volume_folded},
      {"collar-1", "VTSB", kSplines, kStarText, kCollarNumbers, "", nullptr, check_collar},
      {"collar-2", "VTS2", kSplines, kStarText, kCollarNumbers, "", nullptr, check_collar},
      {"vmodel-1", "VTVM", kVolumes, kStarText,
       " bodies boxes cells euler genus half_v_surfaces patches pieces reversed shells singular "
       "subject_bytes v_curves v_points v_surfaces",
       "", nullptr, check_vmodel},
      {"vmodel-invalid-1", "VTVI", kVolumes, kFindingText, " cells subject_bytes", "",
       check_vmodel_finding, check_vmodel_invalid},
      {"microstructure-1", "VTMS", "vmicro", kStarText,
       " bridges cells components genus glued_caps shells subject_bytes tiles", "", nullptr,
       check_micro},
      {"dms-solid-1", "VTDM", "vdms", kStarText,
       " bodies control_points genus leaves patches shells subject_bytes tetrahedra", "", nullptr,
       check_dms},
      {"dms-solid-2", "VTD2", "vdms", kStarText,
       " bodies control_points faces genus leaves shells subject_bytes tetrahedra", "", nullptr,
       check_dms_2},
      {"dms-invalid-1", "VTDI", "vdms", kFindingText, " subject_bytes tetrahedra", "",
       check_dms_finding, check_dms_invalid},
      {"micro-inside-1", "VTIM", "vmicro",
       " body_sha256 certificate claim model_format model_sha256 reading_rule skin subject_format "
       "subject_sha256 tool",
       " bridges cells components genus glued_caps model_bytes shells subject_bytes tiles",
       " as_indexed", check_inside_values, check_micro_inside},
  };
  return claims;
}

std::string claims_as_text() {
  std::string out;
  for (const Claim& c : all_claims()) {
    std::map<std::string, std::string> keys;
    add_keys(c.text, "text", &keys);
    add_keys(c.number, "number", &keys);
    add_keys(c.flag, "flag", &keys);
    out += (out.empty() ? "" : "\n") + std::string(c.name) + ' ' + c.magic + ' ' + c.formats;
    char before = ' ';
    for (const auto& key : keys) {
      out += before + key.first + '=' + key.second;
      before = ',';
    }
  }
  return out;
}
