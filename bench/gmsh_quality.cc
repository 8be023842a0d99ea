// SPDX-License-Identifier: LGPL-3.0-or-later
// The plugin AnalyseMeshQuality of Gmsh.
#include "bench/gmsh_quality.h"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "bench/stopwatch.h"

namespace veritope::bench {
namespace {

// The place in TricubicNodes of each of Gmsh's 64 nodes.
std::vector<std::size_t> places(int type) {
  std::string name;
  int dimension = 0, order = 0, num_nodes = 0, num_primary = 0;
  std::vector<double> at;
  gmsh::model::mesh::getElementProperties(type, name, dimension, order, num_nodes, at, num_primary);
  if (dimension != 3 || order != 3 || num_nodes != 64) throw std::runtime_error("not 64 nodes");
  std::vector<std::size_t> out;
  for (std::size_t n = 0; n < 64; ++n) {
    std::size_t place = 0;
    for (std::size_t a = 0; a < 3; ++a)
      place = 4 * place + static_cast<std::size_t>(std::lround((at[3 * n + a] + 1) * 1.5));
    out.push_back(place);
  }
  return out;
}

}  // namespace

double gmsh_quality_ns(const std::vector<TricubicNodes>& cells, int rounds) {
  gmsh::initialize();
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::model::add("cells");
  const int volume = gmsh::model::addDiscreteEntity(3);
  const int type = gmsh::model::mesh::getElementType("Hexahedron", 3);
  const std::vector<std::size_t> order = places(type);
  std::vector<std::size_t> elements, nodes;
  std::vector<double> coordinates;
  for (const TricubicNodes& cell : cells) {
    elements.push_back(elements.size() + 1);
    for (const std::size_t place : order) {
      nodes.push_back(nodes.size() + 1);
      coordinates.insert(coordinates.end(), cell[place].begin(), cell[place].end());
    }
  }
  gmsh::model::mesh::addNodes(3, volume, nodes, coordinates);
  gmsh::model::mesh::addElementsByType(volume, type, elements, nodes);
  const char* const plugin = "AnalyseMeshQuality";
  gmsh::plugin::setNumber(plugin, "JacobianDeterminant", 1);
  gmsh::plugin::setNumber(plugin, "IGEMeasure", 0);
  gmsh::plugin::setNumber(plugin, "ICNMeasure", 0);
  gmsh::plugin::setNumber(plugin, "CreateView", 0);
  gmsh::plugin::setNumber(plugin, "Recompute", 1);
  gmsh::plugin::setNumber(plugin, "DimensionOfElements", 3);
  gmsh::logger::start();
  gmsh::plugin::run(plugin);
  std::vector<std::string> log;
  gmsh::logger::get(log);
  gmsh::logger::stop();
  if (std::none_of(log.begin(), log.end(),
                   [](const std::string& line) { return line.find("minJ ") != std::string::npos; }))
    throw std::runtime_error("Gmsh reports no bounds of determinants");
  double least = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const Stopwatch watch;
    gmsh::plugin::run(plugin);
    least = std::min(least, watch.ns());
  }
  gmsh::finalize();
  return least / static_cast<double>(cells.size());
}

}  // namespace veritope::bench
