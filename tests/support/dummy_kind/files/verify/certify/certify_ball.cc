// SPDX-License-Identifier: LGPL-3.0-or-later
// certify for balls: a ball is a solid if and only if its radius is positive.
#include <algorithm>

#include "verify/certify/certify_kinds_internal.h"
#include "verify/format/ball_certificate.h"

namespace veritope {
namespace {

certificate::BallNumber stated(const ShortDecimal& n) { return {n.digits, n.decimals}; }

Finding radius_finding(const Ball& ball) {
  Finding out;
  out.code = "radius-not-positive";
  out.place.source.line = BallFile::kRadiusLine;
  out.place.near = Point3d{approx_value(ball.centre[0]), approx_value(ball.centre[1]),
                           approx_value(ball.centre[2])};
  out.message = "the radius is " + certificate::text_of(stated(ball.radius)) +
                (ball.radius.digits == 0 ? ": the ball is a single point" : ": the ball is empty");
  return out;
}

}  // namespace

Result<Certified> internal::certify_kind(const BallFile& file, const CertifyOptions& options) {
  Certified out;
  enter(Phase::kDeciding, options);
  const Ball& ball = file.ball;
  certificate::BallBody body;
  body.is_solid = is_solid(ball);
  if (!body.is_solid) out.findings.push_back(radius_finding(ball));
  enter(Phase::kCertifying, options);
  std::transform(ball.centre.begin(), ball.centre.end(), body.numbers.begin(), stated);
  body.numbers[3] = stated(ball.radius);
  certificate::Subject subject;
  subject.sha256 = file.sha256;
  subject.bytes = file.bytes;
  subject.format = "ball";
  subject.tool = options.tool;
  out.certificate = certificate::encode(subject, body);
  out.claim = body.is_solid ? certificate::kBallClaim : certificate::kBallInvalidClaim;
  out.verdict = body.is_solid ? Verdict::kValid : Verdict::kInvalid;
  return out;
}

}  // namespace veritope
