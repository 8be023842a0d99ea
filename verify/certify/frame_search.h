// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/frame_search.h: a star box around one piece whose sides follow the surface, with one sheet or several:
// searched in floating point, proved by is_sheet_box. Theory: docs/THEORY.md §4b.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "solids/star_box/sheet_box.h"
#include "verify/certify/centre_search.h"
#include "verify/certify/frame_proposals.h"

namespace veritope {

/// A sheet box whose numbers are short: its box is a multiple of `unit` in the frame, its centres of `centre_unit`.
struct FramedBox {
  SheetBox sheets;
  double unit = 1, centre_unit = 1;  ///< powers of two
};

class FrameSearch {
 public:
  using Id = PieceForest::Id;
  /// @param growth   size of a box along the surface, relative to the piece
  /// @param least_unit  the least unit of boxes, in their frames
  /// @param least_centre_unit  the least unit of centres
  FrameSearch(PieceForest& forest, double growth, double least_unit, double least_centre_unit)
      : forest_(forest),
        growth_(growth),
        least_unit_(least_unit),
        least_centre_unit_(least_centre_unit),
        hulls_(forest) {}

  /// Whether a box that contains the piece's hull was found and proved. With one sheet only: the box ends before other
  /// sheets.
  bool try_piece(Id id, bool with_one_sheet_only = false);
  /// After try_piece returned true: the box, and the pieces that it covers, a parent before its children.
  const FramedBox& box() const { return box_; }
  const std::vector<Id>& held() const { return pieces_.held; }

 private:
  /// A box in the frame, as a middle and half sizes in lengths.
  struct Region {
    Point3d middle{}, half{};
    double part = 1;  // pieces that reach out of it are split to this part of the half sizes
    bool ends_at_opposite = false;  // halfway to parts of pieces that face the other way
    Box3d box() const;
  };
  void make_proposals();
  bool try_piece(Id id, bool with_one_sheet_only, FrameProposals& proposals);
  void use(const PieceFrame& chosen);
  /// A normal of the image under the metric, and the hull in lengths.
  Point3d normal_of(Id id);
  Box3d hull_of(Id id);
  bool try_in_frame(bool with_one_sheet_only);
  bool try_tight();
  bool try_several(double height);
  Region region_of_height(double height, double growth) const;
  bool is_small(Id id, const Box3d& hull, const Region& region);
  void hold_near();
  bool gather(const Region& region);
  enum class Cut { kAll, kOpposite, kOppositeParts };
  bool try_one_sheet(const Region& region, Cut which);
  /// A region that was cut: as high as before on the sides that were not, and no higher there than centres need.
  struct CutRegion {
    Region high, low;
  };
  std::optional<CutRegion> cut_back(const Region& region, Cut which);
  std::vector<std::vector<Id>> components() const;
  bool try_sheets(const Region& region, const Region& near,
                  const std::vector<std::vector<Id>>& sheets);
  bool place_centres(const Region& inside, const Region& outside, const std::vector<Id>& pieces,
                     Sheet* sheet);
  void set_half_spaces(const Region& region, const std::vector<Id>& pieces, std::size_t most);
  Point3d rounded(const Region& region, const Point3d& at, double depth);
  bool separate(const std::vector<std::vector<Id>>& sheets, const Region& region);

  PieceForest& forest_;
  const double growth_, least_unit_, least_centre_unit_;
  Id piece_ = 0;
  SearchFrame frame_;
  Box3d hull_{};  // of the piece, in lengths
  FrameHulls hulls_;
  FramedBox box_;
  SheetPieces pieces_;
  std::vector<Id> near_, around_;  // those that the last region meets; that the first region met
  std::vector<HalfSpace> half_spaces_;
  std::size_t most_pieces_ = 0;   // in each sheet, for a proof
  bool had_more_pieces_ = false;  // a proof may have ended for that reason
  /// One in Euclid's metric, and one in that of the model's shape if they differ much; the one that succeeded last is
  /// tried first.
  std::vector<FrameProposals> proposals_;
  std::size_t first_proposals_ = 0;
  const ShapeMetric* metric_ = nullptr;  // of the proposals in use
};

}  // namespace veritope
