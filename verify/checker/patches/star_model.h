// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_model.h: what the readers of spline models share. Their functions only say why they refuse a model;
// read_spline_model adds the place.
#pragma once
#include "star.h"

const size_t kMostDigits = 1000, kMostExponent = 4096;  // for each number of the file
const int64_t kMostSplineDegree = 63;

inline void expect(bool holds, const char* why) {
  if (!holds) throw Refused{why};
}
Ratio read_number(std::string text);          // the forms of docs/formats/spline-json.md
Ratio read_decimal(const std::string& word);  // of at most kMostDigits digits before its exponent
// n / d in lowest terms. REQUIRES that d has no prime factor over 61 (powers of ten, and binomials of a degree below
// 64, have no such factor): Euclid's algorithm would take a step for each other bit.
Ratio shortened(Big n, Big d);

// Knots of this degree; the result is the number of control points along the axis.
uint64_t check_knots(const std::vector<Ratio>& knots, int64_t degree, bool is_periodic);
// Degrees, knots, numbers of points, weights. The entity is a surface or triangle, or else a volume.
void check_entity(const Entity& e, const std::vector<bool>& periodic);
// The places of stored[0] x stored[1] x ... control points in a list of given[0] x given[1] x ... control points, whose
// first axis is the fastest. Along an axis with fewer given ones they repeat.
std::vector<uint64_t> first_axis_fastest(const std::vector<uint64_t>& stored,
                                         const std::vector<uint64_t>& given);

// Where the text of a file begins: after a UTF-8 byte order mark, if there is one.
inline size_t begin_of_text(const std::string& file) {
  return file.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
}
// "line 3, at 'x': ", for messages about files of tokens.
std::string line_and_token(const std::string& file, size_t at);

// Each starts at *at, which follows the reader. has_volumes: the entities are volumes; otherwise a volume is an entity
// of another kind.
std::vector<Entity> read_json_model(const std::string& file, bool has_volumes, size_t* at);
// A model that is one object of the text: what follows it is not read.
std::vector<Entity> read_json_part(const std::string& file, bool has_volumes, size_t* at);
std::vector<Entity> read_itd_model(const std::string& file, bool has_volumes, size_t* at);
std::vector<Entity> read_g2_model(const std::string& file, size_t* at);
std::vector<Entity> read_mfem_model(const std::string& file, size_t* at);

// docs/certificates/reading-rule-faces.md. Section 1: leaves out attributes; refuses an entity that is not as the page
// says.
std::vector<Entity> volumes_in_space(std::vector<Entity> volumes);
// The surfaces that bound the volumes.
std::vector<Entity> boundary_faces(std::vector<Entity> volumes);
