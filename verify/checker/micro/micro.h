// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro.h: what the parts of microstructure-1 share. The pages: docs/certificates/microstructure.md and
// docs/formats/micro-files.md. Walls have their numbers; side e of a patch runs from its corner e to corner e + 1.
#pragma once
#include "../patches/star_model.h"
#include "../vmodel/vmodel.h"
#include "micro_double.h"

const uint64_t kMostMicroCells = uint64_t(1) << 27, kMostWallPairs = 1 << 24;
const int64_t kMostBridgeBits = 8192;  // of its coordinates, as integers with a common denominator
const uint32_t kNoCap = 0xffffffff, kWholeNumber = 1 << 20;  // t = 1 has the number kWholeNumber

struct MicroPatch {
  int wall = -1;  // whose number it depends on; -1: none
  int p = 0, q = 0;
  size_t lists = 0;
  std::vector<Ratio> points;  // as in the file: x, y, z, the second parameter fastest, list by list
  std::vector<Big> net;       // these, times `scale`
  Big scale;                  // > 0

  size_t at(size_t list, int i, int j, size_t coordinate) const {
    return ((list * size_t(p + 1) + size_t(i)) * size_t(q + 1) + size_t(j)) * 3 + coordinate;
  }
  uint64_t coefficients_of_g() const { return uint64_t(9 * p * q) * (3 * lists - 2); }
};

struct MicroCap {
  size_t wall = 0;
  std::vector<uint32_t> patches;
  std::vector<uint32_t> beside;  // the pieces across its rim, without repetition
  int64_t chi = 0;
};

struct MicroTile {
  bool has_range = false;
  uint32_t lo = 0, hi = 0;
  std::vector<MicroPatch> patches;
  bool has_boxes = false;  // it is proved by star boxes: these bytes; otherwise as a family
  Body boxes = {nullptr, nullptr};
  Ratio centre[3];
  uint64_t exit = 0;
  // Filled by check_tile.
  std::vector<uint32_t> pair;    // of side 4 patch + e: the other one; kNoPair: it is collapsed
  std::vector<uint32_t> vertex;  // of corner 4 patch + c
  std::vector<int> in_wall;      // of a patch; -1: it lies in no wall
  std::vector<MicroCap> caps;
  std::vector<uint32_t> cap;  // of a patch, or kNoCap
  std::vector<uint32_t>
      piece;  // of a patch in no cap: its class, joined across sides that bound no cap
  uint32_t pieces = 0;
  int64_t chi = 0;
  bool names_wall[6] = {};
};

struct MicroGrid {
  uint64_t volume = 0;
  std::vector<Ratio> breaks[3];
  size_t n[3];  // intervals along the axes
  size_t ends[3]
             [2];  // ranks of the first and the last break among those of all grids of the volume
  uint64_t first_cell = 0;            // how many cells the grids before it have
  std::vector<uint8_t> tile;          // of a cell: 0, or one more than the tile's number
  std::vector<uint32_t> of_walls[3];  // their numbers; empty if no tile has a range

  // Whether the boxes of two grids of one volume have a common inner point, along all axes but `without`.
  bool overlaps(const MicroGrid& g, size_t without) const {
    for (size_t a = 0; a < 3; ++a)
      if (a != without && (ends[a][0] >= g.ends[a][1] || g.ends[a][0] >= ends[a][1])) return false;
    return true;
  }
  uint64_t cells() const { return uint64_t(n[0]) * n[1] * n[2]; }
  uint64_t cell(const size_t* i) const { return (uint64_t(i[0]) * n[1] + i[1]) * n[2] + i[2]; }
  void place_of(uint64_t number, size_t* i) const {  // of a cell with this number
    i[2] = size_t(number % n[2]);
    i[1] = size_t(number / n[2] % n[1]);
    i[0] = size_t(number / n[2] / n[1]);
  }
  // The number of a wall of cell i; 0 if no tile has a range.
  uint32_t number(const size_t* i, size_t wall) const {
    const size_t a = wall / 2;
    if (of_walls[a].empty()) return 0;
    size_t at[3] = {i[0], i[1], i[2]}, m[3] = {n[0], n[1], n[2]};
    at[a] += wall % 2, ++m[a];
    return of_walls[a][(at[0] * m[1] + at[1]) * m[2] + at[2]];
  }
};
// Calls use(i, number, tile) for each cell of the grid that holds a tile, in order.
template <class Use>
void each_tile(const MicroGrid& g, Use use) {
  size_t i[3];
  uint64_t number = 0;
  for (i[0] = 0; i[0] < g.n[0]; ++i[0])
    for (i[1] = 0; i[1] < g.n[1]; ++i[1])
      for (i[2] = 0; i[2] < g.n[2]; ++i[2], ++number)
        if (g.tile[number] != 0) use(static_cast<const size_t*>(i), number, g.tile[number] - 1);
}

struct MicroBridge {
  size_t grid = 0;
  uint64_t cell = 0, volume = 0;  // the cell's number in the grid
  size_t wall = 0;
  int p = 0, q = 0;
  std::vector<Big>
      net;        // x, y, z times `scale`, the third axis fastest; none: the numbers are too long
  Big scale;      // > 0
  Big matrix[9];  // K of section 7, times a positive number
  std::vector<Ratio> cut;  // s_0 = 0 to s_m = 1

  size_t at(int i, int j, int list) const {
    return ((size_t(i) * size_t(q + 1) + size_t(j)) * 3 + size_t(list)) * 3;
  }
};

// Its numbers are bounded from both sides as they are read: a file may have millions of sweeps, whose conditions are
// decided in double precision.
struct MicroSweep {
  size_t grid = 0;
  uint64_t cell = 0;  // its number in the grid
  size_t wall = 0;
  Span axis[2][3];               // e and f
  Span matrix[9], depth, speed;  // K, d and l of section 7b; {1, 1} if d is 1
  bool is_long = false;          // B2 fails: K, d or l has long numbers
};

struct MicroFile {
  std::vector<Entity> cage;
  std::vector<MicroGrid> grids;
  std::vector<MicroTile> tiles;
  std::vector<MicroBridge> bridges;
  std::vector<MicroSweep> sweeps;
  uint64_t cells = 0, kept = 0;  // of all grids; those that hold a tile
};
// Whether the grid reaches this face of its volume.
bool reaches(const std::vector<Entity>& cage, const MicroGrid& grid, size_t face);
// The first grid of this volume, or of one after it.
size_t first_grid_of(const MicroFile& file, uint64_t volume);
MicroFile read_micro(const std::string& text);  // or throws Refused

// A polynomial in u, v and the tile's range, brought to [0, 1]: Bernstein coefficients times binomials.
struct Cubic {
  int n[3];  // numbers of coefficients along u, v, t; t is the fastest
  std::vector<Big> c;

  int sign(int i, int j, int k) const { return c[size_t((i * n[1] + j) * n[2] + k)].sign(); }
};
// The coefficients in the range, times binomials and a common factor > 0, of a polynomial in t with these ones.
std::vector<Big> in_range(const std::vector<Big>& powers, const MicroTile& tile);
// factor (coordinate c of the patch, times its scale) - minus; or, for axis 0 or 1, the derivative of the coordinate
// along it, up to a positive factor.
Cubic coordinate_of(const MicroTile& tile, const MicroPatch& patch, size_t c, int axis,
                    const Big& factor, const Big& minus);
void put_text(const Big& x,
              std::string* to);  // appends a text that is equal for equal numbers only
// The patch where the number of its wall is k: one list, wall -1.
MicroPatch at_number(const MicroPatch& patch, uint32_t k);
// Bernstein coefficients, stride apart, become those of powers.
void to_powers_of_line(std::vector<Big>* v, size_t first, size_t stride, size_t count);

void check_surface(MicroTile* tile);                           // S0
void check_family(const MicroTile& tile);                      // F1, F2
void check_boxes(const MicroTile& tile, uint64_t file_bytes);  // F3
void check_caps(MicroTile* tile);  // T2, T3; then the caps and pieces are known

// The descents of F2 for a patch of one list: nodes are dropped whose boxes miss the closed box from lo to hi. The
// condition `id` fails if a limit is exceeded; *visited: the nodes so far, of all patches; number: of this one.
void check_missed(const MicroPatch& still, const Ratio* lo, const Ratio* hi, const char* id,
                  uint64_t number, int* visited);

struct PatchOfCell {
  uint32_t grid, patch;
  uint64_t cell;  // its number in the grid
};
// T4 and what section 8 counts.
struct MicroNumbers {
  uint64_t glued_caps = 0, components = 0, shells = 0;
  int64_t chi = 0;  // of N
  // For each bridge, then for each sweep: whether a cap in its wall is equal to another.
  std::vector<bool> is_meeting;
  std::vector<PatchOfCell> first;  // of each shell, if that was asked for: its first patch
};
MicroNumbers check_meetings(const MicroFile& file, const std::vector<FaceCode>& faces,
                            bool with_shells);
// The patch of a tile that is all there is in the wall of a cell, a cap of one patch; or `id` fails, of the bridge or
// sweep with this number.
const MicroPatch& patch_of_cap(const MicroFile& file, size_t grid, uint64_t cell, size_t wall,
                               const char* id, uint64_t number);
// R1 to R4.
void check_bridges(const MicroFile& file, const std::vector<FaceCode>& faces,
                   const std::vector<bool>& is_meeting);
// Q1 to Q4.
void check_sweeps(const MicroFile& file, const std::vector<bool>& is_meeting);

// The conditions of section 2 to 7 for a body about a file of so many bytes. The result are the numbers of section 8.
struct CheckedMicro {
  std::vector<FaceCode> faces;
  std::map<std::string, uint64_t> numbers;
  std::vector<PatchOfCell> shells;  // if that was asked for: their first patches
};
CheckedMicro check_micro_body(MicroFile* file, uint64_t file_bytes, const Body& body,
                              bool with_shells);
