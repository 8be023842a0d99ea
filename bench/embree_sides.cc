// SPDX-License-Identifier: LGPL-3.0-or-later
#include <embree3/rtcore.h>

#include <limits>

#include "bench/side_peers.h"

namespace veritope::bench {
namespace {

struct Count : RTCIntersectContext {
  unsigned hits = 0;
};

// Counts a hit, and rejects it, so that the ray goes on.
void count_hit(const RTCFilterFunctionNArguments* a) {
  ++static_cast<Count*>(a->context)->hits;
  a->valid[0] = 0;
}

}  // namespace

struct EmbreeSides::Impl {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

EmbreeSides::EmbreeSides(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>()) {
  const RTCGeometry g = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* p = static_cast<float*>(rtcSetNewGeometryBuffer(
      g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size()));
  for (const Vec3d& v : mesh.positions) {
    *p++ = static_cast<float>(v.x);
    *p++ = static_cast<float>(v.y);
    *p++ = static_cast<float>(v.z);
  }
  auto* f = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.faces.size()));
  for (const auto& t : mesh.faces)
    for (const std::uint32_t v : t) *f++ = v;
  rtcSetGeometryOccludedFilterFunction(g, count_hit);
  rtcCommitGeometry(g);
  rtcAttachGeometry(impl_->scene, g);
  rtcReleaseGeometry(g);
  rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  rtcSetSceneBuildQuality(impl_->scene, RTC_BUILD_QUALITY_MEDIUM);
  rtcCommitScene(impl_->scene);
}
EmbreeSides::~EmbreeSides() = default;

Side EmbreeSides::operator()(const Vec3d& p) const {
  Count context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  ray.org_x = static_cast<float>(p.x);
  ray.org_y = static_cast<float>(p.y);
  ray.org_z = static_cast<float>(p.z);
  ray.dir_x = 0.382F;
  ray.dir_y = 0.571F;
  ray.dir_z = 0.727F;
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.mask = ~0U;
  rtcOccluded1(impl_->scene, &context, &ray);
  return context.hits % 2 != 0 ? Side::kIn : Side::kOut;
}

}  // namespace veritope::bench
