// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro.cc: the conditions of docs/certificates/microstructure.md in their order.
#include "micro.h"

#include "../patches/star_box.h"
#include "../patches/star_extraction.h"
#include "micro_claim.h"

namespace {

// B2: limits of the bits of a patch's numbers, as integers with a common denominator, and of these bits times
// coefficients of G, over all patches.
const int64_t kMostPatchBits = 4096;
const uint64_t kMostCoefficients = 1 << 18, kMostBitsOfG = 1 << 27;
const uint64_t kMostCostOfBridges = uint64_t(1) << 36;

// B1.
void read_hint(MicroTile* tile, Bytes* bytes) {
  tile->has_boxes = bytes->at_most(bytes->body.natural(1), 1, "there is no proof") == 1;
  if (tile->has_boxes) {
    const uint64_t length = bytes->body.count(1);
    tile->boxes = Body{bytes->body.p, bytes->body.p + length};
    bytes->body.p += length;
    return;
  }
  for (Ratio& a : tile->centre) a = bytes->rational();
  tile->exit = bytes->varint();
  require(tile->exit < tile->patches.size(), "B1", "the exit is no patch:", tile->exit);
}
// B1, and B2 for K and the slices.
void read_hint(MicroBridge* bridge, uint64_t number, Bytes* bytes) {
  std::vector<Ratio> k;
  while (k.size() < 9) k.push_back(bytes->rational());
  bridge->cut = {Ratio(Big(0))};
  const uint64_t m = bytes->body.natural(1);
  require(m > 0 && 2 * (m - 1) <= bytes->body.left(), "B1", "the slices are wrong, of bridge",
          number);
  while (bridge->cut.size() < m) bridge->cut.push_back(bytes->rational());
  bridge->cut.push_back(Ratio(Big(1)));
  for (size_t i = 1; i <= m; ++i)
    require(compare(bridge->cut[i - 1], bridge->cut[i]) < 0, "B1", "slices do not rise, of bridge",
            number);
  for (const std::vector<Ratio>* v : {&k, &bridge->cut})
    for (const Ratio& x : *v)
      if (std::max(x.n.bits(), x.d.bits()) > 64) return bridge->net.clear();  // B2 fails
  const std::vector<Big> matrix = integers_of(k, 9 * 64);
  std::copy(matrix.begin(), matrix.end(), bridge->matrix);
}
// B1, and B2 for K, d and l.
void read_hint(MicroSweep* sweep, uint64_t number, Bytes* bytes) {
  const Ratio one(Big(1));
  for (size_t i = 0; i < 11; ++i) {
    const Ratio x = bytes->rational();
    if (std::max(x.n.bits(), x.d.bits()) > 64) sweep->is_long = true;
    if (i >= 9) require(x.n.sign() > 0, "B1", "d or l is not positive, of sweep", number);
    if (i == 9) require(compare(x, one) <= 0, "B1", "d is over 1, of sweep", number);
    Span& to = i < 9 ? sweep->matrix[i] : i == 9 ? sweep->depth : sweep->speed;
    to = x == one ? Span{1, 1} : span_of(x);
  }
}
void read_hints(MicroFile* file, Bytes* bytes) {  // B1
  require(bytes->body.begins_with("VTMS"), "B1", "another magic number");
  require(bytes->body.count(5) == file->tiles.size(), "B1", "the file's tiles are",
          file->tiles.size());
  const uint64_t bridges = file->bridges.size() + file->sweeps.size();
  require(bytes->body.count(file->sweeps.empty() ? 19 : 22) == bridges, "B1",
          "the file's bridges and sweeps are", bridges);
  for (MicroTile& tile : file->tiles) read_hint(&tile, bytes);
  for (size_t i = 0; i < file->bridges.size(); ++i) read_hint(&file->bridges[i], i, bytes);
  for (size_t i = 0; i < file->sweeps.size(); ++i) read_hint(&file->sweeps[i], i, bytes);
}
void check_costs(const std::vector<MicroBridge>& bridges) {  // B2
  uint64_t cost = 0;
  for (const MicroBridge& b : bridges) {
    require(!b.net.empty(), "B2", "a bridge, its K or its slices have long numbers: bridge",
            uint64_t(&b - bridges.data()));
    int64_t h = b.scale.bits();
    for (const Big& x : b.net) h = std::max(h, x.bits());
    cost += uint64_t((b.p + 1) * (b.q + 1)) * uint64_t((1 + h) * (1 + h)) / 64;
    require(cost <= kMostCostOfBridges, "B2", "the numbers of the bridges are too long, cost",
            cost);
  }
}
void check_limits(MicroFile* file) {  // B2
  uint64_t coefficients = 0, bits = 0;
  for (const MicroTile& tile : file->tiles) {
    for (const Ratio& a : tile.centre)
      require(tile.has_boxes || (a.n.sign() > 0 && a.n < a.d && a.d.bits() <= 64), "B2",
              "a tile's centre is not in the open cube, or has long numbers");
    for (const MicroPatch& s : tile.patches) coefficients += s.coefficients_of_g();
  }
  require(coefficients <= kMostCoefficients, "B2", "too many coefficients of G:", coefficients);
  for (MicroTile& tile : file->tiles)
    for (MicroPatch& s : tile.patches) {
      std::vector<Ratio> all(1, Ratio(Big(1)));
      all.insert(all.end(), s.points.begin(), s.points.end());
      s.net = integers_of(all, kMostPatchBits);
      s.scale = s.net[0];
      s.net.erase(s.net.begin());
      s.points = std::vector<Ratio>();
      int64_t most = s.scale.bits();
      for (const Big& x : s.net) most = std::max(most, x.bits());
      bits += s.coefficients_of_g() * uint64_t(most);
      require(bits <= kMostBitsOfG, "B2", "the numbers of the tiles are too long, bits", bits);
    }
}

void check_cells_of(const MicroFile& file, const MicroGrid& g, const std::vector<FaceCode>& faces) {
  bool is_collapsed[6];
  for (size_t w = 0; w < 6; ++w)
    is_collapsed[w] = faces[6 * g.volume + w].code == 1 && reaches(file.cage, g, w);
  each_tile(g, [&](const size_t* i, uint64_t number, size_t t) {
    const MicroTile& tile = file.tiles[t];
    for (size_t w = 0; w < 6; ++w) {
      const uint32_t k = tile.names_wall[w] ? g.number(i, w) : tile.lo;
      require(tile.lo <= k && k <= tile.hi, "G1",
              "the number of a wall is not in the range of its tile, of cell",
              g.first_cell + number);
    }
    for (const MicroCap& cap : tile.caps) {
      const size_t a = cap.wall / 2;
      require(!is_collapsed[cap.wall] || i[a] != cap.wall % 2 * (g.n[a] - 1), "G2",
              "a cap lies in a collapsed wall, of cell", g.first_cell + number);
    }
  });
}

}  // namespace

bool reaches(const std::vector<Entity>& cage, const MicroGrid& g, size_t face) {
  const std::vector<Ratio>&b = g.breaks[face / 2], &t = cage[g.volume].knots[face / 2];
  return compare(face % 2 == 0 ? b[0] : b.back(), face % 2 == 0 ? t[0] : t.back()) == 0;
}

size_t first_grid_of(const MicroFile& file, uint64_t volume) {
  const auto at = std::lower_bound(file.grids.begin(), file.grids.end(), volume,
                                   [](const MicroGrid& g, uint64_t v) { return g.volume < v; });
  return size_t(at - file.grids.begin());
}

CheckedMicro check_micro_body(MicroFile* file, uint64_t file_bytes, const Body& body,
                              bool with_shells) {
  Bytes bytes(body);
  read_hints(file, &bytes);
  check_limits(file);
  check_costs(file->bridges);
  for (const MicroSweep& b : file->sweeps)
    require(!b.is_long, "B2", "K, d or l has long numbers, of sweep",
            uint64_t(&b - file->sweeps.data()));
  CheckedMicro r;
  r.faces = check_cells(file->cage, file_bytes, bytes.body).faces;
  for (MicroTile& tile : file->tiles) {
    check_surface(&tile);
    if (tile.has_boxes) check_boxes(tile, file_bytes);
    if (!tile.has_boxes) check_family(tile);
    check_caps(&tile);
  }
  for (const MicroGrid& g : file->grids) check_cells_of(*file, g, r.faces);
  MicroNumbers n = check_meetings(*file, r.faces, with_shells);
  r.shells = std::move(n.first);
  check_bridges(*file, r.faces, n.is_meeting);
  check_sweeps(*file, n.is_meeting);
  r.numbers = {{"cells", file->cells},
               {"tiles", file->kept},
               {"bridges", file->bridges.size() + file->sweeps.size()},
               {"glued_caps", n.glued_caps},
               {"components", n.components},
               {"shells", n.shells},
               {"genus", uint64_t(int64_t(n.shells) - n.chi)}};
  return r;
}

std::string check_micro(const Statement& s, std::string model, const Body& body) {
  MicroFile file = read_micro(model);
  model = std::string();
  return compared(s, check_micro_body(&file, s.number.at("subject_bytes"), body, false).numbers);
}
