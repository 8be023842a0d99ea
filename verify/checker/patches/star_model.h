// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_model.h: what the readers of spline models share. Their functions only say why they refuse a
// model; read_spline_model adds the place.
#pragma once
#include "star.h"

const size_t kMostDigits = 1000, kMostExponent = 4096;  // for each number of the file

inline void expect(bool holds, const char* why) {
  if (!holds) throw Refused{why};
}
Ratio read_number(std::string text);  // decimals and the other forms of docs/formats/spline-json.md
// Degrees, knots, numbers of points, weights; `count` points were read.
void check_entity(const Entity& e, const std::vector<bool>& periodic, uint64_t count);

// Starts at *at, which follows the reader.
std::vector<Entity> read_json_model(const std::string& file, size_t* at);
std::vector<Entity> read_itd_model(const std::string& file, size_t* at);
