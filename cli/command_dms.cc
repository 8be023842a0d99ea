// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms: its verbs, each in a file of its own.
#include <array>
#include <utility>

#include "cli/commands.h"
#include "cli/dms_verbs.h"

namespace veritope::cli {

RunCommand declare_dms(OptionSet& set) {
  std::array<RunCommand, 9> runs{
      declare_dms_eval(set.verb("eval", "print the values of a simplex-spline solid at points")),
      declare_dms_fit(set.verb("fit", "write a model that fits data over a domain")),
      declare_dms_make(set.verb("make", "write a model of a higher degree over a domain")),
      declare_dms_domain(set.verb("domain", "write a domain of tetrahedra from points or a mesh")),
      declare_dms_xray(set.verb("xray", "print exact integrals of an attribute along segments")),
      declare_dms_refine(set.verb("refine", "insert a vertex; the map stays equal, or nearly")),
      declare_dms_boundary(set.verb("boundary", "write the surface as Bezier triangles")),
      declare_dms_edit(set.verb("edit", "move control points, coefficients and knots")),
      declare_dms_iso(set.verb("iso", "write the surface where an attribute has a value"))};
  return [&set, runs = std::move(runs)](StandardOutput& out) {
    return runs.at(set.chosen_verb().value())(out);
  };
}

}  // namespace veritope::cli
