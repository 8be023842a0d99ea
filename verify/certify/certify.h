// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/certify.h: the front door: from a model file that was read to a verdict and its certificate.
// Design: docs/design/0021-front-door.md.
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/model_file.h"
#include "robust/base/result.h"
#include "robust/base/work_share.h"
#include "solids/base/finding.h"
#include "solids/base/verdict.h"
#include "verify/certify/dms_facts.h"
#include "verify/certify/mesh_facts.h"
#include "verify/certify/micro_facts.h"
#include "verify/certify/patch_facts.h"
#include "verify/format/mesh_certificate.h"

namespace veritope {

/// What certify is doing, in this order; kSeekingCollar only if a collar was requested and the model is valid.
enum class Phase { kDeciding, kSeekingCollar, kCertifying };

/// "veritope 0.1.0": the tool that certificates name.
std::string tool_name();

struct CertifyOptions {
  /// Named in the certificate's statement: at most 200 bytes of printable ASCII without " and \.
  std::string tool = tool_name();
  /// Threads, of meshes and of the tiles of simplex-spline solids; the result is the same for every number, and 0 is 1.
  unsigned jobs = 1;
  /// How many findings of a mesh are listed for each broken rule, and how many open sides of patches; all are counted.
  std::size_t max_findings = 20;
  std::function<void(Phase)> on_phase;  ///< called when a phase begins, if there is one
  /// If not null, it shows another thread how much is done of a step whose amount is known: the comparisons of faces,
  /// the patches that star boxes cover. Most phases have one such step, some none, and a search that starts anew is
  /// another one.
  WorkShare* work = nullptr;

  /// Patches: kAuto also reverses shells that are wrongly oriented as a whole. Meshes: kAuto reverses faces if that
  /// alone makes the mesh valid, and the certificate (mesh-reversed-1) says which; otherwise nothing is reversed.
  PatchOrientation orientation = PatchOrientation::kKeep;

  // Models of volumes; the other kinds ignore it.
  bool wants_regular = false;  ///< a model whose Jacobian determinant vanishes somewhere is INVALID

  /// Microstructures; the other kinds ignore it. If not null, the microstructure must lie in the interior of the solid
  /// that this mesh, or this file of splines, bounds, and the claim is micro-inside-1. No microstructure.
  const ModelFile* inside = nullptr;

  // Models of patches; the other kinds ignore them.
  bool with_collar = false;  ///< seek a collar; if one is found the claim is collar-1 or collar-2
  /// The most boxes that are tried, and the most octree cells of a collar. Nothing: those of StarCoverOptions and
  /// CollarSearchOptions.
  std::optional<std::uint64_t> max_cells;
  /// The bytes that the structures of the search may take. Nothing: half of the machine's memory. The process takes up
  /// to a tenth more, and what the file and the program take.
  std::optional<std::uint64_t> max_memory;
  /// The width allowed to the volume's enclosure, as in PatchDecisionOptions: positive, finite; nothing: its default.
  std::optional<double> tolerance;
};

/// Further facts about the model, by its kind; monostate for a kind without facts of its own.
using Facts = std::variant<std::monostate, MeshFacts, PatchFacts, MicroFacts, DmsFacts>;

/// A model that was certified in the place of the file: .vjson, or .off for polygons. The checkers do not read the
/// file's format or shapes, or find other boundary faces of its volumes.
struct CertifiedCopy {
  std::string bytes;
  std::string sha256;            ///< 64 lower-case hexadecimal digits
  std::string what;              ///< what of the file it has: "its 7 surfaces"
  bool is_of_volumes = false;    ///< their boundary faces; the verdict says nothing of their cells
  std::string format = "vjson";  ///< or "off": the polygons of the file
};

struct Certified {
  Verdict verdict = Verdict::kUndecided;
  /// VALID: empty. INVALID: what is proved wrong; of meshes at most max_findings for each rule. UNDECIDED: the reasons,
  /// named ones first ("side-t-junction"; at most 19), and at last "not-certified" (neither proved right nor wrong),
  /// "cell-limit" or "memory-limit" (a limit of the options ended the search), or "not-covered" (no certificate can
  /// speak of such a file). With `inside`, also "not-inside" (not proved to lie in the model), and "model-invalid" (the
  /// model is not proved to bound a solid).
  std::vector<Finding> findings;
  Facts facts;
  certificate::Bytes certificate;  ///< empty iff the verdict is kUndecided
  std::string claim;  ///< the claim that the certificate states; empty without a certificate
  /// If that claim is collar-1 or collar-2: the certificate of the star boxes alone, for checkers with too little
  /// memory for cells.
  certificate::Bytes without_collar;
  /// If there is one, the certificate speaks of its bytes. Findings about splines number the entities of the file even
  /// so; those about polygons have the numbers of the copy.
  std::optional<CertifiedCopy> copy;
  /// For a file of volumes, the shapes that the verdict is about: "the 24 boundary faces of its 7 volumes". It says
  /// nothing about their cells. Findings number the volumes, with a copy, too.
  std::optional<std::string> boundary_faces;
};

/// Decides whether the model in the file bounds a solid, and proves the answer. The certificate speaks of the bytes
/// that were read (their SHA-256 and number are in `file`), so that checkers can read them again; or of those of
/// `copy`. No checker has confirmed the result.
/// @error kEmpty, kOverLimit, kBadArgument: the file was read, but holds no model of its kind (a spline file without
/// any surface, a mesh without faces); kBadArgument: an option outside its range
/// @cost  as decide_validity and make_mesh_certificate; as decide_patches. Throws InternalError for a bug of ours, and
/// bad_alloc.
Result<Certified> certify(const ModelFile& file, const CertifyOptions& options = {});

}  // namespace veritope
