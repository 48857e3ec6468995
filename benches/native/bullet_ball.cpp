// Bullet's answers about a sphere and a triangle.

#include <BulletCollision/CollisionDispatch/SphereTriangleDetector.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <limits>

struct BulletBall {
    btVector3 from, way;
    btSphereShape sphere;
    btTriangleShape triangle;
};

// The center, how far it moves, the radius, and three vertices.
extern "C" BulletBall *bullet_ball_new(const float *n) {
    const auto vector = [n](int i) { return btVector3(n[i], n[i + 1], n[i + 2]); };
    BulletBall *ball = new BulletBall{vector(0), vector(3), btSphereShape(n[6]),
                          btTriangleShape(vector(7), vector(10), vector(13))};
    ball->triangle.setMargin(0);
    return ball;
}

extern "C" void bullet_ball_free(BulletBall *ball) { delete ball; }

// The time, or infinity.
extern "C" float bullet_ball_cast(const BulletBall *ball) {
    btVoronoiSimplexSolver solver;
    const auto at = [](const btVector3 &p) { return btTransform(btMatrix3x3::getIdentity(), p); };
    const btTransform still = at(btVector3(0, 0, 0));
    btConvexCast::CastResult result;
    result.m_fraction = 1;
    const bool hit = btSubsimplexConvexCast(&ball->sphere, &ball->triangle, &solver)
                         .calcTimeOfImpact(at(ball->from), at(ball->from + ball->way), still, still, result);
    return hit ? result.m_fraction : std::numeric_limits<float>::infinity();
}

// The depth, or negative infinity.
extern "C" float bullet_ball_depth(BulletBall *ball) {
    btVector3 point, normal;
    btScalar depth, time = 1;
    const bool hit = SphereTriangleDetector(&ball->sphere, &ball->triangle, 0)
                         .collide(ball->from, point, normal, depth, time, 0);
    return hit ? -depth : -std::numeric_limits<float>::infinity();
}

// The point of the triangle that is closest to the center.
extern "C" void bullet_ball_closest(const BulletBall *ball, float *point) {
    btVoronoiSimplexSolver solver;
    btSubSimplexClosestResult closest;
    const btVector3 *t = ball->triangle.m_vertices1;
    solver.closestPtPointTriangle(ball->from, t[0], t[1], t[2], closest);
    for (int i = 0; i < 3; i++) {
        point[i] = closest.m_closestPointOnSimplex[i];
    }
}
