// Jolt's tests of two oriented boxes, and of a ray and a triangle.

#include <Jolt/Jolt.h>

#include <Jolt/Geometry/OrientedBox.h>
#include <Jolt/Geometry/RayTriangle.h>

// As foreign.rs lays them out.
static_assert(sizeof(JPH::OrientedBox) == 80 && alignof(JPH::OrientedBox) == 16);
static_assert(sizeof(JPH::Vec3) == 16);

extern "C" bool jolt_boxes_overlap(const JPH::OrientedBox *a, const JPH::OrientedBox *b) {
    return a->Overlaps(*b);
}

// t, or FLT_MAX.
extern "C" float jolt_ray_triangle(const JPH::Vec3 *ray, const JPH::Vec3 *t) {
    return JPH::RayTriangle(ray[0], ray[1], t[0], t[1], t[2]);
}
