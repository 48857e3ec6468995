/* The stream of one type of numbers: included once for each. */

#define JOIN3(a, b, c) a##b##c
#define JOIN2(a, b) JOIN3(a, b, )
#define NAME(name) JOIN2(name, NUMBER)
#define ASK(query) JOIN2(septum_##query##_, NUMBER)

static const TYPE NAME(NO_END_) = NO_END;

static void NAME(point_)(TYPE *p) {
    for (int k = 0; k < 3; k++) {
        p[k] = FROM(coordinate());
    }
}

static void NAME(report_)(const char *query, int yes) {
    print(query);
    print_number(" yes: ", (uint32_t)yes, 10);
    print_number(", hash ", hash, 16);
    print("\n");
    hash = 2166136261u;
}

/* The torus of mesh.h, and a tree over it. */
#define V(x, y, z) {FROM(x), FROM(y), FROM(z)}
static const TYPE NAME(vertices_)[16][3] = VERTICES;
static const uint16_t NAME(triangles_)[32][3] = JOIN2(TRIANGLES_, NUMBER);
static const uint16_t NAME(nodes_)[3][6][4] = JOIN2(NODES_, NUMBER);
static const ASK(mesh) NAME(mesh_) = {NAME(vertices_), 16, NAME(triangles_), 32, NAME(nodes_), 3};
#undef V

static void NAME(add_contact_)(const ASK(contact) *contact) {
    add(BITS(contact->depth));
    for (int k = 0; k < 3; k++) {
        add(BITS(contact->translation[k]));
    }
    for (int i = 0; i < contact->point_count; i++) {
        add(BITS(contact->points[i].depth));
        add((uint32_t)(contact->points[i].first_part << 8 | contact->points[i].second_part));
    }
}

__attribute__((unused)) static void NAME(check_)(void) {
    static const char *const names[] = {"triangle_aabb", "triangle_obb", "ray_aabb", "ray_triangle",
                                        "ray_triangle_hit", "contains", "triangle_triangle",
                                        "first_hit", "is_hit", "tree_aabb", "aabb_cast", "aabb_cast_triangle",
                                        "contact", "turned_contact", "sphere_triangle", "sphere_aabb", "capsule_triangle",
                                        "capsule_aabb", "closest_point", "tree_closest", "tree_sphere",
                                        "sphere_contact", "sphere_aabb_contact", "capsule_contact",
                                        "capsule_aabb_contact", "ray_sphere_range", "sphere_cast_triangle",
                                        "sphere_cast_aabb", "tree_sphere_cast", "sphere_contacts",
                                        "capsule_contacts"};
    static uint16_t nodes[3][6][4], order[32];
    ASK(tree) built;
    septum_answer is_built = septum_node_count(32) == 3 ? ASK(tree_build)(&NAME(mesh_), nodes, 3, order, &built) : 0;
    ASK(tree) tree;
    septum_answer opened = ASK(tree_open)(&NAME(mesh_), &tree);
    static uint16_t scratch[96][2];
    static uint8_t interior[32];
    if (END > 29) {
        ASK(tree_interior_edges)(&built, scratch, interior);
    }
    hash = 2166136261u;
    for (int query = BEGIN; query < END; query++) {
        int yes = 0;
        state = 1;
        for (int round = 0; round < ROUNDS; round++) {
            ASK(triangle) triangle;
            NAME(point_)(triangle.a);
            NAME(point_)(triangle.b);
            NAME(point_)(triangle.c);
            ASK(aabb) aabb;
            NAME(point_)(aabb.min);
            NAME(point_)(aabb.max);
            for (int k = 0; k < 3; k++) {
                if (aabb.min[k] > aabb.max[k]) {
                    TYPE least = aabb.max[k];
                    aabb.max[k] = aabb.min[k];
                    aabb.min[k] = least;
                }
            }
            /* Turned about z by the angle of the triangle of sides 3, 4 and 5. */
            ASK(obb) obb = {{0, 0, 0},
                            {{FROM(39322), FROM(52429), 0}, {FROM(-52429), FROM(39322), 0}, {0, 0, FROM(65536)}},
                            {FROM(65536), FROM(32768), FROM(16384)}};
            NAME(point_)(obb.center);
            ASK(ray) ray = {.t_min = 0, .t_max = NAME(NO_END_)};
            NAME(point_)(ray.origin);
            NAME(point_)(ray.direction);
            /* A vertex, a point in the plane of the torus, or anywhere. */
            TYPE point[3];
            for (int k = 0; k < 3; k++) {
                point[k] = round % 4 == 0 ? NAME(vertices_)[round / 4 % 16][k] : triangle.a[k];
            }
            if (round % 4 == 1) {
                point[2] = 0;
            }
            ASK(hit) hit = {0, 0, 0, 0, 0};
            ASK(first_contact) first = {0, {0, 0, 0}, 0};
            static ASK(contact) contact;
            contact.point_count = 0;
            ASK(triangle) other = {{aabb.min[0], aabb.min[1], aabb.min[2]}, {aabb.max[0], aabb.max[1], aabb.max[2]}, {obb.center[0], obb.center[1], obb.center[2]}};
            static const TYPE quaternion[4] = {FROM(32768), FROM(32768), FROM(32768), FROM(32768)};
            ASK(obb) turned = obb;
            for (int k = 0; k < 3; k++) {
                turned.center[k] = triangle.b[k];
            }
            TYPE radius = ray.direction[0] < 0 ? (TYPE)-ray.direction[0] : ray.direction[0];
            ASK(sphere) sphere = {{obb.center[0], obb.center[1], obb.center[2]}, radius};
            ASK(capsule) capsule = {{ray.origin[0], ray.origin[1], ray.origin[2]}, {obb.center[0], obb.center[1], obb.center[2]}, radius};
            ASK(closest) closest = {{0, 0, 0}, 0};
            /* A small ball moves. */
            ASK(sphere) ball = {{obb.center[0], obb.center[1], obb.center[2]}, FROM(16384)};
            ASK(sphere_contact) swept = {0, 0};
            ASK(range) range = {0, 0};
            static ASK(contact) contacts[4];
            size_t many = 4, which[4];
            size_t found = 99;
            septum_answer answer = is_built;
            switch (query) {
            case 0:
                answer = ASKS(0) ? ASK(triangle_aabb)(&triangle, &aabb) : is_built;
                break;
            case 1:
                answer = ASKS(1) ? ASK(triangle_obb)(&triangle, &obb) : is_built;
                break;
            case 2:
                answer = ASKS(2) ? ASK(ray_aabb)(&ray, &aabb) : is_built;
                break;
            case 3:
                answer = ASKS(3) ? ASK(ray_triangle)(&ray, &triangle) : is_built;
                break;
            case 4:
                answer = ASKS(4) ? ASK(ray_triangle_hit)(&ray, &triangle, &hit) : is_built;
                break;
            case 5:
                answer = ASKS(5) ? (opened < 0 ? opened : ASK(tree_contains)(&tree, point)) : is_built;
                break;
            case 6:
                answer = ASKS(6) ? ASK(triangle_triangle)(&triangle, &other) : is_built;
                break;
            case 7:
                answer = ASKS(7) ? ASK(tree_first_hit)(&built, &ray, &found, &hit) : is_built;
                break;
            case 8:
                answer = ASKS(8) ? ASK(tree_is_hit)(&built, &ray) : is_built;
                break;
            case 9:
                answer = ASKS(9) ? ASK(tree_aabb)(&built, &aabb, &found) : is_built;
                break;
            case 10:
                answer = ASKS(10) ? ASK(tree_aabb_cast)(&built, &aabb, ray.direction, &found, &first) : is_built;
                break;
            case 11:
                answer = ASKS(11) ? ASK(aabb_cast_triangle)(&aabb, ray.direction, &triangle, &first) : is_built;
                break;
            case 12:
                answer = ASKS(12) ? ASK(triangle_aabb_contact)(&triangle, &aabb, &contact) : is_built;
                break;
            case 13:
                answer = ASKS(13) ? (ASK(obb_turn)(&turned, quaternion) < 0 ? SEPTUM_ANSWER_NOT_UNIT_QUATERNION : ASK(obb_obb_contact)(&obb, &turned, &contact)) : is_built;
                break;
            case 14:
                answer = ASKS(14) ? ASK(sphere_triangle)(&sphere, &triangle) : is_built;
                break;
            case 15:
                answer = ASKS(15) ? ASK(sphere_aabb)(&sphere, &aabb) : is_built;
                break;
            case 16:
                answer = ASKS(16) ? ASK(capsule_triangle)(&capsule, &triangle) : is_built;
                break;
            case 17:
                answer = ASKS(17) ? ASK(capsule_aabb)(&capsule, &aabb) : is_built;
                break;
            case 18:
                answer = ASKS(18) ? ASK(triangle_closest_point)(&triangle, sphere.center, &closest) : is_built;
                break;
            case 19:
                answer = ASKS(19) ? ASK(tree_closest_point)(&built, ray.origin, &found, &closest) : is_built;
                break;
            case 20:
                answer = ASKS(20) ? ASK(tree_sphere)(&built, &sphere, &found) : is_built;
                break;
            case 21:
                answer = ASKS(21) ? ASK(sphere_triangle_contact)(&sphere, &triangle, &contact) : is_built;
                break;
            case 22:
                answer = ASKS(22) ? ASK(sphere_aabb_contact)(&sphere, &aabb, &contact) : is_built;
                break;
            case 23:
                answer = ASKS(23) ? ASK(capsule_triangle_contact)(&capsule, &triangle, &contact) : is_built;
                break;
            case 24:
                answer = ASKS(24) ? ASK(capsule_aabb_contact)(&capsule, &aabb, &contact) : is_built;
                break;
            case 25:
                answer = ASKS(25) ? ASK(ray_sphere_range)(&ray, &sphere, &range) : is_built;
                break;
            case 26:
                answer = ASKS(26) ? ASK(sphere_cast_triangle)(&ball, ray.direction, &triangle, &swept) : is_built;
                break;
            case 27:
                answer = ASKS(27) ? ASK(sphere_cast_aabb)(&ball, ray.direction, &aabb, &swept) : is_built;
                break;
            case 28:
                answer = ASKS(28) ? ASK(tree_sphere_cast)(&built, &ball, ray.direction, &found, &swept) : is_built;
                break;
            case 29:
                answer = ASKS(29) ? ASK(tree_sphere_contacts)(&built, &sphere, interior, which, contacts, &many) : is_built;
                break;
            case 30:
                answer = ASKS(30) ? ASK(tree_capsule_contacts)(&built, &capsule, interior, which, contacts, &many) : is_built;
                break;
            }
            yes += answer == SEPTUM_ANSWER_YES;
            add((uint32_t)answer);
            add(BITS(hit.t));
            add(BITS(hit.u));
            add(BITS(hit.v));
            add((uint32_t)(hit.is_front << 8 | hit.feature));
            if (query < 7) {
                continue;
            }
            add((uint32_t)found);
            add(BITS(first.t));
            add(first.axis);
            for (int k = 0; k < 3 && query > 17; k++) {
                add(BITS(closest.point[k]));
            }
            add(closest.feature);
            if (answer == SEPTUM_ANSWER_YES && (query == 12 || query == 13 || (query > 20 && query < 25))) {
                NAME(add_contact_)(&contact);
            }
            if (query > 24) {
                add(BITS(range.enter));
                add(BITS(range.leave));
                add(BITS(swept.t));
                add(swept.part);
                add((uint32_t)many);
            }
            for (size_t i = 0; query > 28 && i < many && i < 4; i++) {
                add((uint32_t)which[i]);
                NAME(add_contact_)(&contacts[i]);
                add(contacts[i].is_held);
            }
        }
        print(TEXT(NUMBER) " ");
        NAME(report_)(names[query], yes);
    }
}

#undef NUMBER
#undef TYPE
#undef FROM
#undef BITS
#undef NO_END
#undef JOIN3
#undef JOIN2
#undef NAME
#undef ASK
