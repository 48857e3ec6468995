// Bullet's detector of contacts between two boxes.

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <limits>

struct Box {
    btBoxShape shape;
    btTransform at;
};

struct Points final : btDiscreteCollisionDetectorInterface::Result {
    struct Point {
        btVector3 at, normal;
    } all[8];
    int count = 0;
    btScalar deepest = -std::numeric_limits<btScalar>::infinity();

    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    void addContactPoint(const btVector3 &normal, const btVector3 &at, btScalar distance) override {
        if (count < 8) {
            all[count++] = {at, normal};
        }
        deepest = btMax(deepest, -distance);
    }
};

// The center, the axes and the half-extents.
extern "C" Box *bullet_new(const float *n) {
    const btMatrix3x3 axes(n[3], n[6], n[9], n[4], n[7], n[10], n[5], n[8], n[11]);
    Box *box = new Box{btBoxShape(btVector3(n[12], n[13], n[14])),
                       btTransform(axes, btVector3(n[0], n[1], n[2]))};
    box->shape.setMargin(0);
    return box;
}

extern "C" void bullet_free(Box *box) { delete box; }

// The depth of the deepest point; negative infinity if there is none.
extern "C" float bullet_contact(const Box *a, const Box *b) {
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    input.m_transformA = a->at;
    input.m_transformB = b->at;
    Points points;
    btBoxBoxDetector(&a->shape, &b->shape).getClosestPoints(input, points, nullptr);
    return points.deepest;
}
