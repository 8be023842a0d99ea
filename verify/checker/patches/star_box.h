// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_box.h: what is decided in one box, and the walks.
#pragma once
#include "star_bytes.h"
#include "star_forest.h"

struct Piece {  // a tested node
  const Patch* patch;
  Node* node;
};
// C3: REQUIRES that S1 holds on the pieces and that they are all that meet the box in the sheet.
int64_t crossing_number(const std::vector<Piece>& pieces, const Sheet& sheet, Units* units);

struct Facet {  // C4: a tested triangle, of a flat patch
  const Patch* patch;
  int corner[3];     // of the patch
  uint64_t edge[3];  // in X: a pair of sides, or a diagonal
};
// Version 2: a flat patch is the polygon of its corners, section 5 of docs/certificates/star-box-2.md.
bool is_flat_patch(const Patch& p);
// The triangle of a flat triangle, or the two of a flat tensor patch.
std::vector<Facet> facets_of(const Patch& p);
// The closed triangle and the closed box have no common point.
bool misses(const Facet& facet, const Frame& frame, const Box& b);
// No normal is 0, and any two triangles meet exactly in their common face in X.
bool meet_properly(const std::vector<Facet>& facets, Units* units);

struct Walks {
  uint64_t bodies;  // if W2 holds
  int64_t last;     // w(c-) on the last walk's component
  uint64_t wrong;   // the first walk on whose component w(c-) is not 1; none: 2^64 - 1
};
Walks check_walks(const StarBody& body, uint32_t components, Forest* forest, Units* units);  // W1
// The descents of the walk or shore with this number must drop everything; otherwise units->id
// fails.
void check_polyline(const std::vector<int64_t>& points, int end, uint64_t walk, Forest* forest,
                    Units* units);

// The conditions from P1 to W2 (or, if the body is to be turned, the W2 of that claim), in their order.
struct StarCheck {
  StarCheck(StarBody* body, uint64_t bytes, bool is_turned);  // bytes: of the model and the body

  const StarBody& body;
  const Gluing x;
  Units units;
  Forest forest;
  Walks walks;

  // Those that both kinds of statements have.
  std::map<std::string, uint64_t> numbers() const;
};

// W3: the statement has these numbers. The result is their text.
std::string compared(const Statement& statement, const std::map<std::string, uint64_t>& numbers);

struct MoreThanBoxes {  // what a claim on top of star boxes adds
  virtual ~MoreThanBoxes() {}
  virtual void read(StarBytes* bytes) = 0;  // after the walks
  // Called after W3; the result is what ACCEPT prints of the additions.
  virtual std::string check(const Statement& statement, const StarBody& body, const Gluing& x,
                            Forest* forest, Units* units) = 0;
};
std::string check_star_boxes(const Statement& statement, const std::string& model, const Body& body,
                             MoreThanBoxes* more);
