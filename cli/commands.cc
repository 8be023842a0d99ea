// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/commands.h"

#include <array>

namespace veritope::cli {
namespace {

constexpr std::array<Command, 11> kCommands = {{
    {"certify", "decide whether models bound solids, and prove it", declare_certify},
    {"info", "what is in mesh and spline files", declare_info},
    {"convert", "write a mesh or splines in another format, without loss", declare_convert},
    {"intersect", "where the surfaces of two files meet, certified", declare_intersect},
    {"project",
     "all critical points of the distance from a point\nto curves and surfaces, certified",
     declare_project},
    {"cover", "the boxes and cells of a proof, to look at", declare_cover},
    {"explain", "what a rule or an answer means; without RULE: the list", declare_explain},
    {"explain-certificate", "a certificate as text", declare_explain_certificate},
    {"predicate", "exact signs of geometric predicates", declare_predicate},
    {"selftest", "hard signs, decided in two ways, compared", declare_selftest, false},
    {"corpus", "hard cases with their exact signs, as text", declare_corpus},
}};

}  // namespace

std::span<const Command> commands() { return kCommands; }

}  // namespace veritope::cli
