// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_weld.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "robust/base/check.h"
#include "solids/vmodel/control_gap_internal.h"
#include "solids/vmodel/v_near_faces_internal.h"
#include "solids/vmodel/v_weld_round_internal.h"

namespace veritope {
namespace {

using internal::NearPair, internal::WeldClasses, internal::WeldRound;

// Tries to weld pairs until all that are left fit together.
class VWelder {
 public:
  VWelder(const VModel& model, const Rational& eps) : model_(model), eps_(eps) {}

  Result<VWeld> run(std::vector<VVolume> cells) {
    VWeld out;
    out.glued_before = out.glued_after = model_.counts().internal;
    Result<internal::NearFaces> near = internal::near_faces(model_, eps_);
    if (!near) return near.error();
    out.apart = std::move(near->apart);
    pairs_ = std::move(near->pairs);
    std::sort(pairs_.begin(), pairs_.end(), [](const NearPair& a, const NearPair& b) {
      return std::tie(a.distance, a.f) < std::tie(b.distance, b.f);
    });
    if (!pairs_.empty())
      if (auto error = weld_all(cells, out)) return std::move(*error);
    out.cells = std::move(cells);
    std::sort(out.apart.begin(), out.apart.end(), [](const auto& a, const auto& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    });
    return out;
  }

 private:
  std::optional<Error> weld_all(std::vector<VVolume>& cells, VWeld& out) {
    const WeldClasses classes(model_);
    while (!pairs_.empty()) {
      WeldRound round(model_, eps_, pairs_, classes);
      const std::size_t untied = round.failed().size();
      const auto is_sound = [&] { return round.failed().size() == untied; };
      round.place_corners();
      round.make_edges();
      if (is_sound())
        if (auto error = round.make_faces()) return error;
      if (is_sound())
        if (auto error = round.make_cells()) return error;
      if (is_sound())
        if (auto error = test(round)) return error;
      if (is_sound()) {
        finish(round, cells, out);
        return std::nullopt;
      }
      refuse(round, out);
    }
    return std::nullopt;
  }

  // Glues the welded cells. Pairs fail that are not glued, and those around what is not glued any more.
  std::optional<Error> test(WeldRound& round) {
    std::vector<VVolume> all(model_.cells().begin(), model_.cells().end());
    for (const auto& [c, cell] : round.cells()) all[c] = cell.after;
    Result<VModel> welded = make_v_model(std::move(all), VOrientation::kAuto);
    if (!welded) return welded.error();
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (round.is_tied(i) && welded->face(pairs_[i].f).mate != pairs_[i].g)
        round.fail(i, VApartReason::kCollapse);
    for (VFaceNumber f = 0; f < model_.num_faces(); ++f)
      if (model_.face(f).is_glued() && welded->face(f).mate != model_.face(f).mate)
        round.fail_around(f / 6, VApartReason::kCollapse);
    after_ = std::move(*welded);
    return std::nullopt;
  }

  // Pairs that could not be tied may fit in the next round.
  void refuse(const WeldRound& round, VWeld& out) {
    std::vector<NearPair> rest;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto failed = round.failed().find(i);
      if (failed == round.failed().end() || round.was_untied(i)) {
        rest.push_back(std::move(pairs_[i]));
      } else {
        out.apart.push_back(
            {pairs_[i].f, pairs_[i].g, failed->second, std::move(pairs_[i].distance)});
      }
    }
    VT_CHECK(rest.size() < pairs_.size(), "a round failed without a pair that could be refused");
    pairs_ = std::move(rest);
  }

  // The longest way of a control point of the face; 0 in a cell that is not changed.
  static Rational way_of(const WeldRound& round, VFaceNumber f) {
    Rational most(0);
    const auto at = round.cells().find(f / 6);
    if (at == round.cells().end()) return most;
    const internal::FaceView before(at->second.before, f % 6), after(at->second.after, f % 6);
    const auto gap = internal::control_gap(surface_of(before, before.is_rational()),
                                           surface_of(after, after.is_rational()));
    return gap.value();
  }

  VWeldedPair pair_of(const WeldRound& round, VFaceNumber f) const {
    const VFaceRole& role = after_->face(f);
    const auto view = [this](VFaceNumber face) {
      return internal::FaceView(model_.cell(face / 6), face % 6);
    };
    const auto common = internal::in_common_space(view(f), view(role.mate), role.symmetry);
    VWeldedPair out{f, role.mate, role.symmetry,
                    internal::control_gap(common.first, common.second).value(),
                    std::max(way_of(round, f), way_of(round, role.mate))};
    if (!round.wins(f, role.mate)) {
      std::swap(out.winner, out.loser);
      out.symmetry = static_cast<std::uint8_t>(v_symmetry_inverse(role.symmetry));
    }
    return out;
  }

  void finish(const WeldRound& round, std::vector<VVolume>& cells, VWeld& out) const {
    out.glued_after = after_->counts().internal;
    for (VFaceNumber f = 0; f < model_.num_faces(); ++f)
      if (after_->face(f).mate > f && after_->face(f).is_glued() && !model_.face(f).is_glued())
        out.welded.push_back(pair_of(round, f));
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (!round.is_tied(i))
        out.apart.push_back({pairs_[i].f, pairs_[i].g, round.failed().at(i), pairs_[i].distance});
    // Faces may become equal because all of their sides do.
    std::erase_if(out.apart, [this](const VApartPair& pair) {
      return after_->face(pair.first).mate == pair.second;
    });
    for (const auto& [c, cell] : round.cells()) {
      out.changed.push_back(c);
      const Rational way = internal::control_gap(cell.before, cell.after).value();
      if (way > out.largest_displacement) out.largest_displacement = way, out.farthest = c;
      VVolume& whole = cells[c];  // with attributes
      for (std::size_t a = 0; a < 3; ++a)
        whole = internal::raised(std::move(whole), a, cell.spaces[a]);
      for (int k = 0; k < 3; ++k)
        std::copy(cell.after.component(k).begin(), cell.after.component(k).end(),
                  whole.component(k).begin());
    }
  }

  const VModel& model_;
  const Rational& eps_;
  std::vector<NearPair> pairs_;
  std::optional<VModel> after_;  // the cells of the last round that came to its test
};

}  // namespace

const char* v_apart_reason_name(VApartReason reason) {
  switch (reason) {
    case VApartReason::kControlPoints: return "control-points";
    case VApartReason::kWeights: return "weights";
    case VApartReason::kSeveral: return "several";
    case VApartReason::kGlued: return "glued";
    case VApartReason::kTooFar: return "too-far";
    case VApartReason::kCollapse: return "collapse";
  }
  return "";
}

Result<VWeld> weld(std::vector<VVolume> cells, const Rational& eps) {
  VT_CHECK(eps.sign() > 0, "a distance to weld at that is not positive");
  const Result<VModel> model = make_v_model(cells, VOrientation::kAuto);
  if (!model) return model.error();
  return VWelder(*model, eps).run(std::move(cells));
}

}  // namespace veritope
