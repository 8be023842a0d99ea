// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/file_patches.h: the surfaces and triangles of a spline file as one complex of patches, and the
// decision about it: what certify and pictures of proofs have in common.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/splines/read_splines.h"
#include "robust/base/result.h"
#include "solids/base/finding.h"
#include "verify/certify/certificate_entities.h"
#include "verify/certify/patch_certifier.h"
#include "verify/certify/patch_decision.h"

namespace veritope {

/// An inner knot of a surface with a multiplicity above the degree of its axis.
struct TornKnot {
  std::uint64_t entity = 0;
  std::size_t axis = 0;  ///< 0: a knot of u
  Rational at;
  std::array<std::array<double, 2>, 2>
      domain{};            ///< of the surface, along u and v, rounded outward
  bool is_broken = false;  ///< the pieces on both sides do not agree along it; otherwise they do
};

/// The patches of a file, in the order of its entities.
struct FilePatches {
  /// Null if the file has something that is no surface or triangle in space; not_covered says what.
  std::unique_ptr<const PatchComplex> complex;
  std::vector<StarBoxEntity> entities;
  /// An entity some of whose patches were reversed, not all: no certificate can speak of that.
  std::optional<std::size_t> mixed_entity;
  /// At such knots a surface may be torn into pieces, and sides of pieces that no other surface shares may be open.
  /// VALID is proved even so; INVALID would be about the pieces and not about the surfaces.
  std::vector<TornKnot> torn;
  std::optional<Finding> not_covered;

  /// The numbers of the entities that are reversed, ascending.
  std::vector<std::uint64_t> reversed() const;
};

/// @param faces  where the surfaces of the model lie, if they are the boundary faces of a file's volumes
/// @error kEmpty: no surface and no triangle; kOverLimit, kBadArgument: as patch_source and make_patch_complex
Result<FilePatches> file_patches(const SplineModel& model, PatchOrientation orientation,
                                 std::span<const VolumeFace> faces = {});

/// Reverses all patches of these entities. REQUIRES patches.complex, and numbers of entities.
void reverse_entities(FilePatches& patches, std::span<const std::uint64_t> entities);

/// For boundary faces of volumes: what keeps them from being a closed oriented surface, named by volumes and not, as
/// describe does, by the surfaces of the complex, which the file does not have. Nothing for other files, or for a
/// closed oriented surface. REQUIRES patches.complex.
std::optional<std::string> open_faces_text(const FilePatches& patches);

/// The frame that the search may use.
enum class FrameWanted {
  kAny,
  kPlainIfCheap,  ///< the plain frame, which collars need, unless it costs far more than the frame that fits the model
  kPlain,
};

struct FileDecisionOptions {
  PatchDecisionOptions search;  ///< its `outer` and `in_plain_frame` are set here
  FrameWanted frame = FrameWanted::kAny;
  /// Reverse shells that are wrongly oriented as a whole (an outer shell that points inward, a cavity that points
  /// outward), then decide again.
  bool may_turn_shells = false;
};

struct FileDecision {
  PatchDecision decision;
  std::optional<PieceForest>
      forest;  ///< the decision's node numbers point into it; it refers to the complex
};

/// Changes `patches` only where shells are reversed. REQUIRES patches.complex.
FileDecision decide_file_patches(FilePatches& patches, const FileDecisionOptions& options);

/// Names the bytes that were read as certificates do. `by_faces`: their entities are boundary faces.
certificate::Subject subject_of(const SplineFile& file, const std::string& tool,
                                bool by_faces = false);

/// Calls make_patch_certificate. REQUIRES a decision of these patches that is not open.
certificate::Bytes make_patch_certificate(const FilePatches& patches, const FileDecision& decided,
                                          const certificate::Subject& subject);

}  // namespace veritope
