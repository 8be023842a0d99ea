// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/sweep_proof.h"

#include <optional>
#include <string>
#include <utility>

#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/bridge/sweep_clearance_internal.h"
#include "solids/micro/matched_caps.h"

namespace veritope {
namespace {

using internal::PairBudget;
using internal::PlacedSweep;

// The page lets a checker visit 2^22 pairs, and 2^12 more for each sweep.
constexpr std::uint64_t kAllPairs = std::uint64_t{1} << 21, kPairsOfSweep = 1 << 11;

// What is known of one sweep.
struct SweepProof {
  std::optional<SweepWitness> witness;
  const char* failed = nullptr;  // the condition
  std::uint64_t spent = 0;
};

class SweepProver {
 public:
  SweepProver(const Microstructure& micro, const VModel& cage,
              const std::vector<AnalysedTile>& tiles, std::vector<internal::VolumeSpace> spaces,
              unsigned jobs)
      : micro_(micro),
        spaces_(std::move(spaces)),
        starts_(micro, tiles),
        in_space_(micro, spaces_, jobs),
        most_(kAllPairs + kPairsOfSweep * micro.sweeps.size()),
        jobs_(jobs) {
    std::vector<CapPlace> places;
    for (const MicroSweep& s : micro.sweeps) places.push_back(s.cap);
    matched_ = matched_caps(micro, cage, tiles, places);
  }

  std::variant<std::vector<SweepWitness>, BridgeDefect> run() {
    std::vector<SweepProof> proofs(micro_.sweeps.size());
    parallel_for(proofs.size(), 4, jobs_, [&](std::size_t, std::size_t begin, std::size_t end) {
      const ScopedUpward upward;
      for (std::size_t i = begin; i < end; ++i) proofs[i] = prove(micro_.sweeps[i]);
    });
    PairBudget budget{most_, 0};
    for (std::size_t i = 0; i < proofs.size(); ++i) {
      if (proofs[i].failed != nullptr) return defect(proofs[i].failed, i);
      budget.spent += proofs[i].spent;
      if (budget.is_spent()) return defect("Q3", i);
    }
    const ScopedUpward upward;
    std::vector<SweepWitness> out;
    internal::DisjointSweeps disjoint;
    for (std::size_t i = 0; i < proofs.size(); ++i) {
      const SweepWitness& witness = *proofs[i].witness;
      if (const auto other = disjoint.add(PlacedSweep(starts_, micro_.sweeps[i], witness), budget))
        return BridgeDefect{"Q4", i,
                            "it is not proved disjoint from sweep " + std::to_string(*other)};
      out.push_back(witness);
    }
    return out;
  }

 private:
  SweepProof prove(const MicroSweep& sweep) const {
    SweepProof out;
    if (!starts_.cap(sweep.cap) || matched_.contains(sweep.cap)) {
      out.failed = "Q1";
      return out;
    }
    out.witness = find_sweep_witness(starts_, sweep);
    if (!out.witness) {
      out.failed = "Q2";
      return out;
    }
    PlacedSweep placed(starts_, sweep, *out.witness);
    PairBudget budget{most_, 0};
    if (!in_space_.are_missed_by(placed, budget)) out.failed = "Q3";
    out.spent = budget.spent;
    return out;
  }
  BridgeDefect defect(const std::string& condition, std::size_t sweep) const {
    if (condition == "Q1") {
      const bool is_matched = matched_.contains(micro_.sweeps[sweep].cap);
      return {"Q1", sweep,
              is_matched ? "its cap is equal to another one"
                         : "the patches in its wall are not one cap of one patch"};
    }
    if (condition == "Q2")
      return {"Q2", sweep,
              "no matrix was found that shows that it is one to one and leaves its tile"};
    return {"Q3", sweep, "it is not proved to miss the surfaces of tiles"};
  }

  const Microstructure& micro_;
  std::vector<internal::VolumeSpace> spaces_;
  SweepStarts starts_;
  internal::TilesInSpace in_space_;
  std::set<CapPlace> matched_;
  std::uint64_t most_;
  unsigned jobs_;
};

}  // namespace

Result<std::variant<std::vector<SweepWitness>, BridgeDefect>> prove_sweeps(
    const Microstructure& micro, const VModel& cage, const std::vector<AnalysedTile>& tiles,
    unsigned jobs) {
  using Proof = std::variant<std::vector<SweepWitness>, BridgeDefect>;
  if (micro.sweeps.empty()) return Proof(std::vector<SweepWitness>());
  std::vector<internal::VolumeSpace> spaces;
  for (const VVolume& volume : micro.cage) {
    Result<internal::VolumeSpace> space = internal::VolumeSpace::make(volume);
    if (!space) return space.error();
    spaces.push_back(std::move(*space));
  }
  return SweepProver(micro, cage, tiles, std::move(spaces), jobs).run();
}

}  // namespace veritope
