// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/commands.h"

#include <array>

namespace veritope::cli {
namespace {

constexpr std::array<Command, 20> kCommands = {{
    {"certify", "decide whether models bound solids, and prove it", declare_certify},
    {"info", "list what is in mesh and spline files", declare_info},
    {"inspect", "list the elements of volumes and what they share", declare_inspect},
    {"convert", "write a mesh or splines in another format, without loss", declare_convert},
    {"build", "write volumes from a tree of shapes and constructors", declare_build},
    {"cage", "write a cage of volumes that guides microstructures", declare_cage},
    {"micro", "write a microstructure: tiles that lie in a solid", declare_micro},
    {"dms", "print values of simplex-spline solids, and make them", declare_dms},
    {"intersect", "find where the surfaces of two files meet, and prove it", declare_intersect},
    {"project", "find where distances are critical, and prove it", declare_project},
    {"classify", "decide whether points are in, on or out of a solid", declare_classify},
    {"boolean", "write an expression of solids, for classify", declare_boolean},
    {"chain", "list the cells of a solid's chains, and what they cost", declare_chain},
    {"render", "write a picture of a solid, its cells, or points in it", declare_render},
    {"cover", "write the boxes and cells of a proof, to look at", declare_cover},
    {"explain", "explain a rule or an answer; without RULE list them", declare_explain},
    {"explain-certificate", "print a certificate as text", declare_explain_certificate},
    {"predicate", "print exact signs of geometric predicates", declare_predicate},
    {"selftest", "decide hard signs in two ways, and compare them", declare_selftest, false},
    {"corpus", "write hard cases and models with their exact answers", declare_corpus},
}};

}  // namespace

std::span<const Command> commands() { return kCommands; }

}  // namespace veritope::cli
