/* Asks every function a stream of questions and prints a hash of the answers: the same on
   every machine, and the same as examples/expected.rs prints, which asks the crate itself. */

#include "board.h"
#include "mesh.h"
#include "septum.h"

/* xorshift, by Marsaglia (2003). */
static uint32_t state;

static uint32_t next(void) {
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

/* FNV-1a, of 32 bits. */
static uint32_t hash;

static void add(uint32_t word) {
    for (int k = 0; k < 4; k++) {
        hash = (hash ^ (word >> 8 * k & 255)) * 16777619u;
    }
}

__attribute__((unused)) static uint32_t bits_f32(float x) {
    union {
        float number;
        uint32_t bits;
    } both = {x};
    return both.bits;
}

/* A double as 32 bits: its halves, mixed. */
__attribute__((unused)) static uint32_t bits_f64(double x) {
    union {
        double number;
        uint64_t bits;
    } both = {x};
    return (uint32_t)(both.bits >> 32) * 31u + (uint32_t)both.bits;
}

/* From -2 to 2, in 65,536ths. */
static int32_t coordinate(void) { return (int32_t)(next() >> 14) - 131072; }

#define ROUNDS 256

/* A number alone, if a board has no room for all: 8, 16, 32; 0 for the errors. */
#ifndef ONLY
#define ONLY 64
#endif
/* And some of the questions alone, from one number to another. */
#ifndef BEGIN
#define BEGIN 0
#define END 31
#endif
#define ASKS(query) ((query) >= BEGIN && (query) < END)

#if ONLY == 8 || ONLY == 64
#define NUMBER i8f8
#define TYPE septum_i8f8
#define FROM(x) ((septum_i8f8)((x) / 256))
#define BITS(x) ((uint32_t)(x))
#define NO_END 32767
#include "check_one.h"

#endif
#if ONLY == 16 || ONLY == 64 || ONLY == 0
#define NUMBER i16f16
#define TYPE septum_i16f16
#define FROM(x) (x)
#define BITS(x) ((uint32_t)(x))
#define NO_END 2147483647
#include "check_one.h"

#endif
#if ONLY == 32 || ONLY == 64 || ONLY == 0
#define NUMBER f32
#define TYPE float
#define FROM(x) ((float)(x) / 65536.0f)
#define BITS(x) bits_f32(x)
#define NO_END __builtin_inff()
#include "check_one.h"

#endif
#if ONLY == 64
/* Its tree is that of `float`, for all coordinates are. */
#define NODES_f64 NODES_f32
#define TRIANGLES_f64 TRIANGLES_f32
#define NUMBER f64
#define TYPE double
#define FROM(x) ((double)(x) / 65536.0)
#define BITS(x) bits_f64(x)
#define NO_END __builtin_inf()
#include "check_one.h"
#endif

#if ONLY == 0 || ONLY == 64
/* What is wrong with a question is told, and nothing else happens. */
static int errors(void) {
    septum_triangle_i16f16 triangle = {{0, 0, 0}, {65536, 0, 0}, {0, 65536, 0}};
    septum_aabb_i16f16 inverted = {{0, 0, 1}, {1, 1, 0}};
    septum_obb_i16f16 no_box = {{0, 0, 0}, {{65536, 0, 0}, {65536, 0, 0}, {0, 0, 65536}}, {1, 1, 1}};
    septum_obb_i16f16 negative = {{0, 0, 0}, {{65536, 0, 0}, {0, 65536, 0}, {0, 0, 65536}}, {1, -1, 1}};
    septum_ray_i16f16 still = {{0, 0, 0}, {0, 0, 0}, 0, NO_END_i16f16};
    septum_ray_i16f16 no_range = {.origin = {0, 0, 1}, .direction = {0, 0, -1}};
    static const septum_i16f16 no_turn[4] = {65536, 65536, 0, 0};
    septum_ray_i16f16 empty = {{0, 0, 0}, {1, 0, 0}, 2, 1};
    septum_triangle_f32 nan = {{__builtin_nanf(""), 0, 0}, {0, 0, 0}, {0, 0, 0}};
    septum_aabb_f32 box = {{0, 0, 0}, {1, 1, 1}};
    septum_mesh_i16f16 no_vertex = mesh_i16f16, few_nodes = mesh_i16f16, other_tree = mesh_i16f16, null = mesh_i16f16;
    no_vertex.vertex_count = 15;
    few_nodes.node_count = 2;
    other_tree.nodes++;
    other_tree.node_count = 1;
    other_tree.triangle_count = 4;
    null.triangles = 0;
    septum_tree_i16f16 tree, zero = {{0}};
    static const septum_i16f16 point[3] = {0, 0, 0};
    septum_tree_f32 of_floats;
    septum_sphere_i16f16 ball = {{0, 0, 0}, 4 << 16};
    size_t many = 1;
    static const float nowhere[3] = {0, __builtin_inff(), 0};
    int meshes = septum_tree_open_i16f16(&no_vertex, &tree) == SEPTUM_ANSWER_NO_SUCH_VERTEX
        && septum_tree_open_i16f16(&few_nodes, &tree) == SEPTUM_ANSWER_WRONG_NODE_COUNT
        && septum_tree_open_i16f16(&other_tree, &tree) == SEPTUM_ANSWER_BROKEN_TREE
        && septum_tree_open_i16f16(&null, &tree) == SEPTUM_ANSWER_NULL_POINTER
        && septum_tree_open_i16f16(&mesh_i16f16, 0) == SEPTUM_ANSWER_NULL_POINTER
        && septum_tree_open_i16f16(&mesh_i16f16, &tree) == SEPTUM_ANSWER_YES
        && septum_tree_contains_i16f16(&tree, 0) == SEPTUM_ANSWER_NULL_POINTER
        && septum_tree_contains_i16f16(&tree, point) == SEPTUM_ANSWER_NO
        && septum_tree_contains_i16f16(&zero, point) == SEPTUM_ANSWER_NOT_OPEN
        && septum_tree_open_f32(&mesh_f32, &of_floats) == SEPTUM_ANSWER_YES
        && septum_tree_contains_f32(&of_floats, nowhere) == SEPTUM_ANSWER_NOT_FINITE
        && septum_tree_sphere_contacts_i16f16(&tree, &ball, 0, 0, 0, &many) == SEPTUM_ANSWER_NULL_POINTER
        && septum_tree_interior_edges_i16f16(&tree, 0, 0) == SEPTUM_ANSWER_NULL_POINTER;
    many = 0;
    meshes = meshes && septum_tree_sphere_contacts_i16f16(&zero, &ball, 0, 0, 0, &many) == SEPTUM_ANSWER_NOT_OPEN
        && septum_tree_sphere_contacts_i16f16(&tree, &ball, 0, 0, 0, &many) == SEPTUM_ANSWER_YES && many == 32;
    ball.radius = -1;
    many = 0;
    meshes = meshes
        && septum_tree_sphere_contacts_i16f16(&tree, &ball, 0, 0, 0, &many) == SEPTUM_ANSWER_NEGATIVE_RADIUS;
    return meshes && septum_triangle_aabb_i16f16(&triangle, 0) == SEPTUM_ANSWER_NULL_POINTER
        && septum_triangle_aabb_i16f16(&triangle, &inverted) == SEPTUM_ANSWER_MIN_ABOVE_MAX
        && septum_triangle_obb_i16f16(&triangle, &no_box) == SEPTUM_ANSWER_NOT_ORTHONORMAL
        && septum_triangle_obb_i16f16(&triangle, &negative) == SEPTUM_ANSWER_NEGATIVE_HALF_EXTENT
        && septum_ray_triangle_i16f16(&still, &triangle) == SEPTUM_ANSWER_ZERO_DIRECTION
        && septum_ray_triangle_i16f16(&empty, &triangle) == SEPTUM_ANSWER_EMPTY_RANGE
        && septum_ray_triangle_i16f16(&no_range, &triangle) == SEPTUM_ANSWER_NO_RANGE
        && septum_tree_is_hit_i16f16(&tree, &no_range) == SEPTUM_ANSWER_NO_RANGE
        && septum_obb_turn_i16f16(&no_box, no_turn) == SEPTUM_ANSWER_NOT_UNIT_QUATERNION
        && septum_text(SEPTUM_ANSWER_NO_RANGE)[0] == 't' && septum_text(7)[0] == 'n'
        && septum_ray_triangle_hit_i16f16(&still, &triangle, 0) == SEPTUM_ANSWER_NULL_POINTER
        && septum_triangle_aabb_f32(&nan, &box) == SEPTUM_ANSWER_NOT_FINITE;
}

#endif

int main(void) {
#if ONLY == 8 || ONLY == 64
    check_i8f8();
#endif
#if ONLY == 16 || ONLY == 64
    check_i16f16();
#endif
#if ONLY == 32 || ONLY == 64
    check_f32();
#endif
#if ONLY == 64
    check_f64();
#endif
#if ONLY == 0 || ONLY == 64
    int told = errors();
    print(told ? "errors are told\n" : "AN ERROR IS NOT TOLD\n");
    return !told;
#else
    return 0;
#endif
}
