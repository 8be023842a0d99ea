// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/trees/tree_node.h"

namespace veritope {

std::span<const TreeOp> tree_ops() {
  using enum TreeValueKind;
  static const std::vector<TreeOp> ops = {
      {"box", {{"min", kPoint}, {"max", kPoint}}},
      {"cylinder", {{"radius", kNumber}, {"height", kNumber}, {"cells", kText, false}}},
      {"cone", {{"bottom", kNumber}, {"top", kNumber}, {"height", kNumber}}},
      {"torus", {{"major", kNumber}, {"minor", kNumber}}},
      {"sphere", {{"radius", kNumber}, {"cells", kText, false}}},
      {"trivariate", {{"shape", kShape}}},
      {"file", {{"path", kText}, {"entity", kCount, false}}},
      {"extrude", {{"surface", kSurface}, {"vector", kPoint}}},
      {"ruled", {{"surfaces", kSurfaces}}},
      {"revolve",
       {{"surface", kSurface}, {"point", kPoint}, {"axis", kPoint}, {"degrees", kNumber, false}}},
      {"boolean-sum", {{"faces", kSixFaces}, {"arrange", kFlag, false}}},
      {"sweep",
       {{"sections", kSurfaces}, {"parameters", kNumbers}, {"degree", kCount}, {"mode", kText}}},
      {"tube", {{"surface", kSurface}}},
      {"glue", {{"of", kNodes}}},
      {"place",
       {{"of", kNode},
        {"matrix", kMatrix, false},
        {"scale", kScale, false},
        {"rotate", kRotation, false},
        {"translate", kPoint, false}}},
      {"split", {{"of", kNode}, {"axis", kText}, {"at", kNumber}}},
  };
  return ops;
}

}  // namespace veritope
