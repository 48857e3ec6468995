// Jolt's answers about a sphere and a triangle.

#include <Jolt/Jolt.h>

#include <Jolt/Geometry/ClosestPoint.h>
#include <Jolt/Physics/Collision/CastSphereVsTriangles.h>
#include <Jolt/Physics/Collision/CollideShape.h>
#include <Jolt/Physics/Collision/CollideSphereVsTriangles.h>
#include <Jolt/Physics/Collision/CollisionCollectorImpl.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>

using namespace JPH;

// Bullet's has a name of its own: C++ would take both for one type.
struct JoltBall {
    Vec3 from, way, triangle[3];
    Ref<SphereShape> sphere;
    ShapeCastSettings cast;
    CollideShapeSettings collide;
};

static const Vec3 ONE = Vec3::sReplicate(1);
static const uint8 ALL_EDGES = 0b111;

// The center, how far it moves, the radius, and three vertices.
extern "C" JoltBall *jolt_ball_new(const float *n) {
    RegisterDefaultAllocator();
    const auto vector = [n](int i) { return Vec3(n[i], n[i + 1], n[i + 2]); };
    JoltBall *ball = new JoltBall{
        vector(0), vector(3), {vector(7), vector(10), vector(13)}, new SphereShape(n[6]), {}, {}};
    ball->cast.mBackFaceModeTriangles = EBackFaceMode::CollideWithBackFaces;
    ball->collide.mBackFaceMode = EBackFaceMode::CollideWithBackFaces;
    return ball;
}

extern "C" void jolt_ball_free(JoltBall *ball) { delete ball; }

// The time, or infinity.
extern "C" float jolt_ball_cast(const JoltBall *ball) {
    const ShapeCast cast(ball->sphere, ONE, Mat44::sTranslation(ball->from), ball->way);
    ClosestHitCollisionCollector<CastShapeCollector> first;
    const Mat44 still = Mat44::sIdentity();
    CastSphereVsTriangles caster(cast, ball->cast, ONE, still, SubShapeIDCreator(), first);
    const Vec3 *t = ball->triangle;
    caster.Cast(t[0], t[1], t[2], ALL_EDGES, SubShapeID());
    return first.HadHit() ? first.mHit.mFraction : INFINITY;
}

// The depth, or negative infinity.
extern "C" float jolt_ball_depth(const JoltBall *ball) {
    ClosestHitCollisionCollector<CollideShapeCollector> deepest;
    const Mat44 at = Mat44::sTranslation(ball->from);
    CollideSphereVsTriangles collider(ball->sphere, ONE, ONE, at, Mat44::sIdentity(), SubShapeID(),
                                      ball->collide, deepest);
    const Vec3 *t = ball->triangle;
    collider.Collide(t[0], t[1], t[2], ALL_EDGES, SubShapeID());
    return deepest.HadHit() ? deepest.mHit.mPenetrationDepth : -INFINITY;
}

// The point of the triangle that is closest to the center.
extern "C" void jolt_ball_closest(const JoltBall *ball, float *point) {
    const Vec3 p = ball->from, *t = ball->triangle;
    uint32 set;
    (p + ClosestPoint::GetClosestPointOnTriangle(t[0] - p, t[1] - p, t[2] - p, set))
        .StoreFloat3(reinterpret_cast<Float3 *>(point));
}
