// A scene of embree with one mesh.

#include <algorithm>
#include <embree3/rtcore.h>
#include <limits>

struct Scene {
    RTCDevice device;
    RTCScene scene;
};

extern "C" Scene *embree_new(const float *vertices, size_t vertex_count, const unsigned *triangles,
                             size_t triangle_count, bool is_robust) {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, is_robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void *to = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                       3 * sizeof(float), vertex_count);
    std::copy_n(vertices, 3 * vertex_count, static_cast<float *>(to));
    to = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                 3 * sizeof(unsigned), triangle_count);
    std::copy_n(triangles, 3 * triangle_count, static_cast<unsigned *>(to));
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene);
    return new Scene{device, scene};
}

extern "C" void embree_free(Scene *s) {
    rtcReleaseScene(s->scene);
    rtcReleaseDevice(s->device);
    delete s;
}

// From an origin along a direction, without end.
static RTCRay ray_of(const float *n) {
    RTCRay ray{};
    ray.org_x = n[0], ray.org_y = n[1], ray.org_z = n[2];
    ray.dir_x = n[3], ray.dir_y = n[4], ray.dir_z = n[5];
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = -1;
    return ray;
}

extern "C" bool embree_first_hit(const Scene *s, const float *n) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit found{ray_of(n), {}};
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(s->scene, &context, &found);
    return found.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

extern "C" bool embree_any_hit(const Scene *s, const float *n) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = ray_of(n);
    rtcOccluded1(s->scene, &context, &ray);
    return ray.tfar < 0;
}
