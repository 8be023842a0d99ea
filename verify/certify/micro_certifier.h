// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/micro_certifier.h: certify for microstructures. Theory: docs/THEORY.md, MICRO-1. The page:
// docs/certificates/microstructure.md. Design: docs/design/0071-microstructures.md.
#pragma once
#include <variant>
#include <vector>

#include "solids/micro/micro_topology.h"
#include "verify/certify/certify.h"
#include "verify/format/micro_certificate.h"

namespace veritope {

/// What is known without a proof: volumes, kinds, cells and tiles.
MicroFacts micro_facts_of(const Microstructure& micro);

/// What proves a microstructure-1 claim, and what further proofs need.
struct MicroProof {
  certificate::MicroBody body;
  std::vector<AnalysedTile> tiles;
  MicroCounts counts;
  std::vector<CellPatch> first_patches;  ///< of the shells, as topology_of lists them
};
certificate::MicroQuantities quantities_of(const MicroCounts& counts);

/// The proof, or an UNDECIDED as certify_microstructure has it, which also has the requirements and the cost.
std::variant<MicroProof, Certified> prove_microstructure(const Microstructure& micro,
                                                         const certificate::Subject& subject,
                                                         const CertifyOptions& options);

/// VALID with its certificate (microstructure-1), or UNDECIDED: "not-certified", with the condition of the page that
/// is not proved to hold and the place in the cage's parameters; or "not-covered".
/// @param subject  the bytes of the file
/// REQUIRES validate(micro).
/// @cost  that of certify for the cage; polynomial in the degrees of the tiles; near-linear in the cells, 20 bytes
/// each
Certified certify_microstructure(const Microstructure& micro, const certificate::Subject& subject,
                                 const CertifyOptions& options);

}  // namespace veritope
