// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/micro_certifier.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "io/splines/read_splines.h"
#include "robust/base/check.h"
#include "solids/micro/bridge/bridge_proof.h"
#include "solids/micro/bridge/sweep_proof.h"
#include "solids/micro/micro_topology.h"
#include "verify/certify/certificate_entities.h"
#include "verify/certify/certify_kinds_internal.h"
#include "verify/certify/tile_certifier.h"
#include "verify/certify/vmodel_certifier.h"
#include "verify/format/claims.h"

namespace veritope {
namespace {

constexpr std::size_t kMaxCaps = 64;  // of a tile; a limit of this program
// B2 of the page.
constexpr std::uint64_t kMaxPatchBits = 4096, kMaxFamilySize = 1 << 18, kMaxFamilyWork = 1 << 27;

class MicroCertification {
 public:
  MicroCertification(const Microstructure& micro, const certificate::Subject& subject,
                     const CertifyOptions& options)
      : micro_(micro), subject_(subject), options_(options) {
    out_.facts = micro_facts_of(micro);
  }

  std::variant<MicroProof, Certified> run() {
    internal::enter(Phase::kDeciding, options_);
    for (std::size_t k = 0; k < micro_.tiles.size(); ++k)
      if (auto reason = analyse(k)) return undecided(std::move(*reason));
    if (auto reason = long_numbers()) return undecided(std::move(*reason));
    if (auto reason = certify_cage()) return undecided(std::move(*reason));
    Result<VModel> cage = make_v_model(micro_.cage, VOrientation::kAuto);
    VT_CHECK(cage.has_value(), "the cage was certified");
    MicroProof proof;
    auto topology = topology_of(micro_, *cage, tiles_, &proof.first_patches);
    if (const auto* defect = std::get_if<MicroDefect>(&topology))
      return undecided(reason_of(*defect));
    proof.counts = std::get<MicroCounts>(topology);
    auto reason = micro_.sweeps.empty() ? certify_bridges(*cage) : certify_sweeps(*cage);
    if (reason) return undecided(std::move(*reason));
    internal::enter(Phase::kCertifying, options_);
    proof.body = std::move(body_);
    proof.tiles = std::move(tiles_);
    return proof;
  }

 private:
  static Finding reason(const std::string& message, const char* code = "not-certified") {
    Finding out;
    out.code = code;
    out.message = message;
    return out;
  }
  Certified undecided(Finding finding) {
    out_.verdict = Verdict::kUndecided;
    out_.findings.assign(1, std::move(finding));
    return std::move(out_);
  }

  std::optional<Finding> analyse(std::size_t k) {
    auto analysed = analyse_tile(micro_.tiles[k]);
    const std::string name = "tile " + std::to_string(k);
    if (const auto* defect = std::get_if<TileDefect>(&analysed))
      return reason(name + ": " + defect->condition + ": " + defect->message);
    tiles_.push_back(std::get<AnalysedTile>(std::move(analysed)));
    if (tiles_.back().caps.size() > kMaxCaps)
      return reason(name + " has " + std::to_string(tiles_.back().caps.size()) + " caps; at most " +
                        std::to_string(kMaxCaps) + " are supported",
                    "not-covered");
    return prove(tiles_.back(), name);
  }
  // Appends the proof that the tile is a solid.
  std::optional<Finding> prove(const AnalysedTile& tile, const std::string& name) {
    if (const auto* const star = std::get_if<TileStar>(&tile.star)) {
      certificate::StarTileProof proof;
      for (std::size_t c = 0; c < 3; ++c) proof.centre[c] = to_fraction(star->centre[c]);
      proof.exit = star->exit;
      body_.tiles.emplace_back(std::move(proof));
      return std::nullopt;
    }
    auto boxes = star_boxes_of(tile.tile, options_);
    if (auto* const finding = std::get_if<Finding>(&boxes))
      return reason(name + ": F3: " + finding->code + ": " + finding->message);
    body_.tiles.emplace_back(std::get<certificate::StarBoxBody>(std::move(boxes)));
    return std::nullopt;
  }

  // B2
  std::optional<Finding> long_numbers() const {
    std::uint64_t all = 0, work = 0;
    for (const AnalysedTile& tile : tiles_)
      for (const TilePatch& patch : tile.tile.patches) {
        const auto c = 9 * static_cast<std::uint64_t>(patch.degrees[0] * patch.degrees[1]) *
                       (3 * patch.points.size() - 2);
        const std::uint64_t bits = bits_of(patch);
        all += c;
        work += c * bits;
        if (bits > kMaxPatchBits || all > kMaxFamilySize || work > kMaxFamilyWork)
          return reason("the tiles have too many or too long numbers", "not-covered");
      }
    return std::nullopt;
  }
  static std::uint64_t bits_of(const TilePatch& patch) {
    Integer common(1);
    for (const auto& list : patch.points)
      for (const TilePoint& p : list)
        for (const Rational& x : p) common = lcm(common, x.denominator());
    std::uint64_t bits = common.bit_length();
    for (const auto& list : patch.points)
      for (const TilePoint& p : list)
        for (const Rational& x : p)
          bits = std::max<std::uint64_t>(bits, (x * Rational(common)).numerator().bit_length());
    return bits;
  }

  std::optional<Finding> certify_cage() {
    SplineFile file;
    file.format = SplineFormat::kJson;
    file.bytes = subject_.bytes;
    file.sha256 = subject_.sha256;
    for (const VVolume& volume : micro_.cage)
      file.model.entities.push_back({volume, {}, std::nullopt, {}});
    CertifyOptions options = options_;
    options.orientation = PatchOrientation::kAuto;
    options.with_collar = options.wants_regular = false;
    options.on_phase = nullptr;
    const std::optional<VModelAnswer> answer = certify_vmodel(file, options);
    if (!answer.has_value())
      return reason("no certificate can speak of the volumes of the cage", "not-covered");
    const Certified& cage = answer->certified;
    if (cage.verdict != Verdict::kValid) {
      Finding out = cage.findings.front();
      out.message = std::string("the cage is ") +
                    (cage.verdict == Verdict::kInvalid ? "INVALID" : "UNDECIDED") + ": " +
                    out.code + ": " + out.message;
      out.code = "not-certified";
      return out;
    }
    std::string why;
    auto decoded = certificate::decode_certificate(cage.certificate, why);
    VT_CHECK(decoded.has_value(), "a certificate of our own is not read");
    body_.cage = std::get<certificate::VModelBody>(std::move(decoded->body));
    return std::nullopt;
  }

  std::optional<Finding> certify_bridges(const VModel& cage) {
    auto proof = prove_bridges(micro_, cage, tiles_);
    if (const auto* d = std::get_if<BridgeDefect>(&proof))
      return reason_at(*d, "bridge ", micro_.bridges[d->bridge].cap);
    std::vector<certificate::BridgeProof> bridges;
    for (const BridgeWitness& w : std::get<0>(proof)) {
      certificate::BridgeProof& out = bridges.emplace_back();
      for (std::size_t i = 0; i < 9; ++i) out.matrix[i] = to_fraction(w.matrix[i]);
      for (const Rational& s : w.cuts) out.cuts.push_back(to_fraction(s));
    }
    body_.bridges = std::move(bridges);
    return std::nullopt;
  }
  std::optional<Finding> certify_sweeps(const VModel& cage) {
    const auto proof = prove_sweeps(micro_, cage, tiles_, options_.jobs);
    if (!proof) return reason("the sweeps: " + proof.error().message, "not-covered");
    if (const auto* d = std::get_if<BridgeDefect>(&*proof))
      return reason_at(*d, "sweep ", micro_.sweeps[d->bridge].cap);
    std::vector<certificate::SweepProof> sweeps;
    for (const SweepWitness& w : std::get<0>(*proof)) {
      certificate::SweepProof& out = sweeps.emplace_back();
      for (std::size_t i = 0; i < 9; ++i) out.matrix[i] = to_fraction(w.matrix[i]);
      out.depth = to_fraction(w.depth);
      out.speed = to_fraction(w.speed);
    }
    body_.bridges = std::move(sweeps);
    return std::nullopt;
  }
  Finding reason_at(const BridgeDefect& d, const char* what, const CapPlace& cap) const {
    const CellWall wall{cap.grid, cap.cell, cap.wall};
    const MicroDefect defect{d.condition,
                             {wall},
                             what + std::to_string(d.bridge) + " at wall " +
                                 name_of_wall(micro_, wall) + ": " + d.message};
    return reason_of(defect, d.condition == std::string("B2") ? "not-covered" : "not-certified");
  }

  // The finding, with the cells' boxes in the parameters of the cage.
  Finding reason_of(const MicroDefect& defect, const char* code = "not-certified") const {
    Finding out = reason(std::string(defect.condition) + ": " + defect.message, code);
    for (const CellWall& w : defect.walls) {
      const MicroGrid& grid = micro_.grids[w.grid];
      const auto at = grid.shape().index_of(w.cell);
      EntityPart part;
      part.entity = grid.volume;
      part.is_of_volume = true;
      for (std::size_t a = 0; a < 3; ++a)
        part.parameters.push_back(
            {round_down(grid.breaks[a][at[a]]), round_up(grid.breaks[a][at[a] + 1])});
      out.place.parts.push_back(std::move(part));
    }
    return out;
  }

  const Microstructure& micro_;
  const certificate::Subject& subject_;
  const CertifyOptions& options_;
  Certified out_;
  std::vector<AnalysedTile> tiles_;
  certificate::MicroBody body_;
};

}  // namespace

MicroFacts micro_facts_of(const Microstructure& micro) {
  MicroFacts out;
  out.volumes = micro.cage.size();
  out.kinds = micro.tiles.size();
  out.counts.bridges = micro.num_bridges();
  for (const MicroGrid& g : micro.grids) {
    out.counts.cells += g.tiles.size();
    for (const std::uint8_t t : g.tiles) out.counts.tiles += t != 0;
  }
  return out;
}

certificate::MicroQuantities quantities_of(const MicroCounts& n) {
  return {n.cells,
          n.tiles,
          n.bridges,
          n.glued_caps,
          n.components,
          n.shells,
          static_cast<std::uint64_t>(n.genus)};
}

std::variant<MicroProof, Certified> prove_microstructure(const Microstructure& micro,
                                                         const certificate::Subject& subject,
                                                         const CertifyOptions& options) {
  return MicroCertification(micro, subject, options).run();
}

Certified certify_microstructure(const Microstructure& micro, const certificate::Subject& subject,
                                 const CertifyOptions& options) {
  auto proved = prove_microstructure(micro, subject, options);
  if (auto* const undecided = std::get_if<Certified>(&proved)) return std::move(*undecided);
  const auto& proof = std::get<MicroProof>(proved);
  Certified out;
  MicroFacts facts = micro_facts_of(micro);
  facts.counts = proof.counts;
  out.facts = std::move(facts);
  out.certificate = certificate::encode(subject, quantities_of(proof.counts), proof.body);
  out.claim = certificate::kMicroClaim;
  out.verdict = Verdict::kValid;
  return out;
}

}  // namespace veritope
