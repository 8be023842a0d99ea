// SPDX-License-Identifier: Apache-2.0 OR MIT
// points.cc: the claim points-1; conditions B1 and P1 to P4 of docs/certificates/points.md.
#include "expression_points.h"
#include "mesh_points.h"
#include "patch_points.h"
#include "points_claim.h"

namespace {

// Sets the codes of the answers: B1, except the work.
void read_body(const Model& model, Body body, std::vector<Answer>* answers) {
  require(body.begins_with("VTPT"), "B1", "the body does not start with VTPT");
  require(body.natural(4) == model.faces(), "B1", "the model's number of triangles is",
          model.faces());
  require(body.natural(4) == model.vertices(), "B1", "the model's number of vertices is",
          model.vertices());
  require(body.natural(8) == answers->size(), "B1", "the number of points is", answers->size());
  for (Answer& a : *answers) {
    const uint64_t line = uint64_t(&a - answers->data()) + 1;
    if (a.word == Answer::kUndecided) continue;
    const uint64_t code = a.word == Answer::kOn ? body.varint() : body.natural(1);
    require(code < (a.word == Answer::kOn ? model.faces() : 6), "B1", "unknown code of line", line);
    a.code = uint32_t(code);
  }
  require(body.left() == 0, "B1", "bytes follow the codes:", body.left());
}

class PointsCheck {
 public:
  PointsCheck(const Statement& statement, const Model& model, const Body& body)
      : mesh_(model), nearest_(statement.text.at("decimals") == "nearest"), work_(model, body) {}

  // The first condition that fails is named, and the work comes first: after a failure it is only counted.
  void check(const std::vector<Answer>& answers) {
    work_.limit = 10 * uint64_t(mesh_.model().faces()) + 1000 * uint64_t(answers.size());
    if (!mesh_.is_closed()) fail("P1", "the triangles are no closed chain");
    for (size_t i = 0; i < answers.size(); ++i) {
      if (answers[i].word == Answer::kUndecided) continue;
      Coordinate c[3];
      read_point(answers[i], nearest_, c);
      const Point q(c, mesh_.lattice());
      check_point(q, answers[i], " in line " + std::to_string(i + 1));
    }
    if (has_failed()) throw failure_;
  }

 private:
  bool has_failed() const { return !failure_.id.empty(); }
  void fail(const char* id, const std::string& why) {
    if (!has_failed()) failure_ = Rejected{id, why};
  }
  void check_point(const Point& q, const Answer& a, const std::string& line) {
    if (a.word == Answer::kOn) {
      work_.add(1);
      if (!has_failed() && !mesh_.is_on(q, a.code))
        fail("P2", "the triangle of its code does not contain the point" + line);
      return;
    }
    const MeshPoints::Winding found = mesh_.winding(q, int(a.code), has_failed(), &work_);
    if (found.is_on) fail("P3", "a triangle contains the point" + line);
    if (found.sum != a.f)
      fail("P4", "the winding number is not f, but " + std::to_string(found.sum) + line);
  }

  const MeshPoints mesh_;
  const bool nearest_;
  Work work_;
  Rejected failure_;
};

}  // namespace

std::string check_points(const Statement& statement, std::string file, const Body& body) {
  std::vector<Answer> answers = read_answers(statement);
  const std::string counts = std::to_string(answers.size()) + " points, " +
                             std::to_string(statement.number.at("on")) + " on, " +
                             std::to_string(statement.number.at("undecided")) + " undecided";
  if (is_about_expression(statement)) {
    const uint64_t open = check_points_of_expression(statement, file, body, answers);
    return counts + ", " + std::to_string(open) + " not covered";
  }
  if (is_about_patches(statement)) {
    check_points_of_patches(statement, file, body, answers);
    return counts;
  }
  const Model model = read_model(std::move(file), statement.text.at("subject_format"),
                                 statement.flag.at("as_indexed"));
  read_body(model, body, &answers);
  PointsCheck(statement, model, body).check(answers);
  return counts;
}
