// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/patch_entities.h: how certificates of patch models describe the entities of the file: as plain data,
// and its encoding. The page: docs/certificates/star-box.md, section 2.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "verify/format/mesh_certificate.h"

namespace veritope::certificate {

/// A fraction in lowest terms; denominator > 0.
struct Fraction {
  bool is_negative = false;
  Natural numerator, denominator;
};

/// One entity of the model: a surface with its breaks along u and v, or a triangle without.
struct PatchEntity {
  bool is_reversed = false;
  bool is_surface = true;
  /// Version 2 only: neither surface nor triangle, without patches (every checker rejects it: B2).
  bool is_other = false;
  std::array<std::vector<Fraction>, 2> breaks;
};

/// The number of entities that are reversed.
std::uint64_t num_reversed(const std::vector<PatchEntity>& entities);

namespace internal {
class ByteReader;
class ByteWriter;
/// Writes the number of entities, all flags, then the breaks of the surfaces.
void write(ByteWriter& w, const std::vector<PatchEntity>& entities);
/// Writes the breaks of a surface, along u and then along v.
void write_breaks(ByteWriter& w, const PatchEntity& entity);
void write_fraction(ByteWriter& w, const Fraction& fraction);
Fraction read_fraction(ByteReader& r);
/// Reads what write() writes; false unless there are is_surface.size() entities, with at least two
/// breaks an axis.
bool read(ByteReader& r, const std::vector<bool>& is_surface, std::vector<PatchEntity>& out);
/// Bodies of version 2 give the kind of every entity before its flag.
void write_with_kinds(ByteWriter& w, const std::vector<PatchEntity>& entities);
bool read_with_kinds(ByteReader& r, std::vector<PatchEntity>& out);
}  // namespace internal

}  // namespace veritope::certificate
