// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/volume_subject.h: what certificates about the volumes of a file speak of: its own bytes, or those of a
// copy.
#pragma once
#include <optional>
#include <string>

#include "io/splines/read_splines.h"
#include "verify/certify/certify.h"

namespace veritope {

/// Whether all entities of the file are volumes in space, and nothing else of it keeps certificates from speaking of
/// it.
bool has_only_volumes(const SplineFile& file);

/// The file itself, or a .vjson copy of its volumes.
struct VolumeSubject {
  std::string bytes;  ///< of the copy
  std::optional<SplineFile> copy;

  /// The entities have the same numbers in both.
  const SplineFile& file(const SplineFile& own) const { return copy ? *copy : own; }
  std::optional<CertifiedCopy> certified_copy() const;
};
/// A copy is made of a file that the checkers do not read, and of volumes with axes that are not clamped, which are
/// clamped in it. Nothing if the copy's numbers exceed the limits of certificates, or a volume may be torn at a knot.
/// REQUIRES has_only_volumes(file).
std::optional<VolumeSubject> volume_subject_of(const SplineFile& file);

}  // namespace veritope
