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

static void NAME(check_)(void) {
    static const char *const names[] = {"triangle_aabb", "triangle_obb", "ray_aabb", "ray_triangle",
                                        "ray_triangle_hit", "contains"};
    ASK(tree) tree;
    septum_answer opened = ASK(tree_open)(&NAME(mesh_), &tree);
    hash = 2166136261u;
    for (int query = 0; query < 6; query++) {
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
            septum_answer answer = query == 0   ? ASK(triangle_aabb)(&triangle, &aabb)
                                   : query == 1 ? ASK(triangle_obb)(&triangle, &obb)
                                   : query == 2 ? ASK(ray_aabb)(&ray, &aabb)
                                   : query == 3 ? ASK(ray_triangle)(&ray, &triangle)
                                   : query == 4 ? ASK(ray_triangle_hit)(&ray, &triangle, &hit)
                                   : opened < 0 ? opened
                                                : ASK(contains)(&tree, (const TYPE(*)[3]) & point);
            yes += answer == SEPTUM_ANSWER_YES;
            add((uint32_t)answer);
            add(BITS(hit.t));
            add(BITS(hit.u));
            add(BITS(hit.v));
            add((uint32_t)(hit.is_front << 8 | hit.feature));
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
