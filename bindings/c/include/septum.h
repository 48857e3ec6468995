#ifndef SEPTUM_H
#define SEPTUM_H

// Made by cbindgen from bindings/c/src: see bindings/c/README.md.

#include <stddef.h>
#include <stdint.h>

// An answer, or an error, which is negative.
enum septum_answer
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  SEPTUM_ANSWER_NO = 0,
  SEPTUM_ANSWER_YES = 1,
  // A pointer is null.
  SEPTUM_ANSWER_NULL_POINTER = -1,
  // A coordinate is NaN or infinite.
  SEPTUM_ANSWER_NOT_FINITE = -2,
  // A half-extent is negative.
  SEPTUM_ANSWER_NEGATIVE_HALF_EXTENT = -3,
  // The least corner of a box lies above its greatest.
  SEPTUM_ANSWER_MIN_ABOVE_MAX = -4,
  // The axes of a box are not unit vectors at right angles.
  SEPTUM_ANSWER_NOT_ORTHONORMAL = -5,
  // A ray's direction is zero.
  SEPTUM_ANSWER_ZERO_DIRECTION = -6,
  // A range ends before it begins.
  SEPTUM_ANSWER_EMPTY_RANGE = -7,
  // A triangle of a mesh refers to a vertex that does not exist.
  SEPTUM_ANSWER_NO_SUCH_VERTEX = -8,
  // A mesh has the wrong number of nodes for its tree.
  SEPTUM_ANSWER_WRONG_NODE_COUNT = -9,
  // A box of a tree does not enclose everything below it.
  SEPTUM_ANSWER_BROKEN_TREE = -10,
  // A tree was not opened.
  SEPTUM_ANSWER_NOT_OPEN = -11,
  // A mesh has more triangles than 16-bit indices can number.
  SEPTUM_ANSWER_TOO_MANY_TRIANGLES = -12,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum septum_answer septum_answer;
#else
typedef int32_t septum_answer;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Fixed point of 8 fraction bits: a number times 256.
typedef int16_t septum_i8f8;

// A triangle. It may be a segment or a point.
typedef struct {
  septum_i8f8 a[3];
  septum_i8f8 b[3];
  septum_i8f8 c[3];
} septum_triangle_i8f8;

// An axis-aligned box by its least and greatest corner. It may be flat.
typedef struct {
  septum_i8f8 min[3];
  septum_i8f8 max[3];
} septum_aabb_i8f8;

// Fixed point of 16 fraction bits: a number times 65,536.
typedef int32_t septum_i16f16;

// A triangle. It may be a segment or a point.
typedef struct {
  septum_i16f16 a[3];
  septum_i16f16 b[3];
  septum_i16f16 c[3];
} septum_triangle_i16f16;

// An axis-aligned box by its least and greatest corner. It may be flat.
typedef struct {
  septum_i16f16 min[3];
  septum_i16f16 max[3];
} septum_aabb_i16f16;

// A triangle. It may be a segment or a point.
typedef struct {
  float a[3];
  float b[3];
  float c[3];
} septum_triangle_f32;

// An axis-aligned box by its least and greatest corner. It may be flat.
typedef struct {
  float min[3];
  float max[3];
} septum_aabb_f32;

// An oriented box: axes are three unit vectors at right angles to each other.
typedef struct {
  septum_i8f8 center[3];
  septum_i8f8 axes[3][3];
  septum_i8f8 half_extents[3];
} septum_obb_i8f8;

// An oriented box: axes are three unit vectors at right angles to each other.
typedef struct {
  septum_i16f16 center[3];
  septum_i16f16 axes[3][3];
  septum_i16f16 half_extents[3];
} septum_obb_i16f16;

// An oriented box: axes are three unit vectors at right angles to each other.
typedef struct {
  float center[3];
  float axes[3][3];
  float half_extents[3];
} septum_obb_f32;

// A ray, from origin + t_min · direction to origin + t_max · direction. The direction may have any
// length except zero. The least number of the type as t_min, and the greatest as t_max, mean an
// unbounded end; in `float` these are the infinities.
typedef struct {
  septum_i8f8 origin[3];
  septum_i8f8 direction[3];
  septum_i8f8 t_min;
  septum_i8f8 t_max;
} septum_ray_i8f8;

// A ray, from origin + t_min · direction to origin + t_max · direction. The direction may have any
// length except zero. The least number of the type as t_min, and the greatest as t_max, mean an
// unbounded end; in `float` these are the infinities.
typedef struct {
  septum_i16f16 origin[3];
  septum_i16f16 direction[3];
  septum_i16f16 t_min;
  septum_i16f16 t_max;
} septum_ray_i16f16;

// A ray, from origin + t_min · direction to origin + t_max · direction. The direction may have any
// length except zero. The least number of the type as t_min, and the greatest as t_max, mean an
// unbounded end; in `float` these are the infinities.
typedef struct {
  float origin[3];
  float direction[3];
  float t_min;
  float t_max;
} septum_ray_f32;

// A hit of a ray on a triangle. `t` is the distance along the ray in units of its direction; `u`
// and `v` are the barycentric coordinates of b and c. `is_front` is 1 if a, b, c go
// counterclockwise seen from the ray's origin. `feature` is 0 for the interior, 1, 2, 3 for the
// edges ab, bc, ca, and 4, 5, 6 for the vertices a, b, c.
typedef struct {
  septum_i8f8 t;
  septum_i8f8 u;
  septum_i8f8 v;
  uint8_t is_front;
  uint8_t feature;
} septum_hit_i8f8;

// A hit of a ray on a triangle. `t` is the distance along the ray in units of its direction; `u`
// and `v` are the barycentric coordinates of b and c. `is_front` is 1 if a, b, c go
// counterclockwise seen from the ray's origin. `feature` is 0 for the interior, 1, 2, 3 for the
// edges ab, bc, ca, and 4, 5, 6 for the vertices a, b, c.
typedef struct {
  septum_i16f16 t;
  septum_i16f16 u;
  septum_i16f16 v;
  uint8_t is_front;
  uint8_t feature;
} septum_hit_i16f16;

// A hit of a ray on a triangle. `t` is the distance along the ray in units of its direction; `u`
// and `v` are the barycentric coordinates of b and c. `is_front` is 1 if a, b, c go
// counterclockwise seen from the ray's origin. `feature` is 0 for the interior, 1, 2, 3 for the
// edges ab, bc, ca, and 4, 5, 6 for the vertices a, b, c.
typedef struct {
  float t;
  float u;
  float v;
  uint8_t is_front;
  uint8_t feature;
} septum_hit_f32;

// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
// vertices, and are listed in the tree's order. septum's example `quantise` writes such tables.
typedef struct {
  const septum_i8f8 (*vertices)[3];
  size_t vertex_count;
  const uint16_t (*triangles)[3];
  size_t triangle_count;
  const uint16_t (*nodes)[6][4];
  size_t node_count;
} septum_mesh_i8f8;

// A mesh that has been checked. Only `septum_tree_open` writes one. It may be copied, but the mesh
// must stay where it is.
typedef struct {
  // Private to the library.
  uint64_t opaque[24];
} septum_tree_i8f8;

// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
// vertices, and are listed in the tree's order. septum's example `quantise` writes such tables.
typedef struct {
  const septum_i16f16 (*vertices)[3];
  size_t vertex_count;
  const uint16_t (*triangles)[3];
  size_t triangle_count;
  const uint16_t (*nodes)[6][4];
  size_t node_count;
} septum_mesh_i16f16;

// A mesh that has been checked. Only `septum_tree_open` writes one. It may be copied, but the mesh
// must stay where it is.
typedef struct {
  // Private to the library.
  uint64_t opaque[24];
} septum_tree_i16f16;

// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
// vertices, and are listed in the tree's order. septum's example `quantise` writes such tables.
typedef struct {
  const float (*vertices)[3];
  size_t vertex_count;
  const uint16_t (*triangles)[3];
  size_t triangle_count;
  const uint16_t (*nodes)[6][4];
  size_t node_count;
} septum_mesh_f32;

// A mesh that has been checked. Only `septum_tree_open` writes one. It may be copied, but the mesh
// must stay where it is.
typedef struct {
  // Private to the library.
  uint64_t opaque[24];
} septum_tree_f32;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Whether a triangle overlaps an axis-aligned box, exactly.
septum_answer septum_triangle_aabb_i8f8(const septum_triangle_i8f8 *triangle, const septum_aabb_i8f8 *aabb);

// Whether a triangle overlaps an axis-aligned box, exactly.
septum_answer septum_triangle_aabb_i16f16(const septum_triangle_i16f16 *triangle, const septum_aabb_i16f16 *aabb);

// Whether a triangle overlaps an axis-aligned box, exactly.
septum_answer septum_triangle_aabb_f32(const septum_triangle_f32 *triangle, const septum_aabb_f32 *aabb);

// Whether a triangle overlaps an oriented box, exactly for the numbers given.
septum_answer septum_triangle_obb_i8f8(const septum_triangle_i8f8 *triangle, const septum_obb_i8f8 *obb);

// Whether a triangle overlaps an oriented box, exactly for the numbers given.
septum_answer septum_triangle_obb_i16f16(const septum_triangle_i16f16 *triangle, const septum_obb_i16f16 *obb);

// Whether a triangle overlaps an oriented box, exactly for the numbers given.
septum_answer septum_triangle_obb_f32(const septum_triangle_f32 *triangle, const septum_obb_f32 *obb);

// Whether a ray meets an axis-aligned box, exactly.
septum_answer septum_ray_aabb_i8f8(const septum_ray_i8f8 *ray, const septum_aabb_i8f8 *aabb);

// Whether a ray meets an axis-aligned box, exactly.
septum_answer septum_ray_aabb_i16f16(const septum_ray_i16f16 *ray, const septum_aabb_i16f16 *aabb);

// Whether a ray meets an axis-aligned box, exactly.
septum_answer septum_ray_aabb_f32(const septum_ray_f32 *ray, const septum_aabb_f32 *aabb);

// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
septum_answer septum_ray_triangle_i8f8(const septum_ray_i8f8 *ray, const septum_triangle_i8f8 *triangle);

// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
septum_answer septum_ray_triangle_i16f16(const septum_ray_i16f16 *ray, const septum_triangle_i16f16 *triangle);

// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
septum_answer septum_ray_triangle_f32(const septum_ray_f32 *ray, const septum_triangle_f32 *triangle);

// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in `float`.
septum_answer septum_ray_triangle_hit_i8f8(const septum_ray_i8f8 *ray, const septum_triangle_i8f8 *triangle, septum_hit_i8f8 *hit);

// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in `float`.
septum_answer septum_ray_triangle_hit_i16f16(const septum_ray_i16f16 *ray, const septum_triangle_i16f16 *triangle, septum_hit_i16f16 *hit);

// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in `float`.
septum_answer septum_ray_triangle_hit_f32(const septum_ray_f32 *ray, const septum_triangle_f32 *triangle, septum_hit_f32 *hit);

// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
// yes.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used.
septum_answer septum_tree_open_i8f8(const septum_mesh_i8f8 *mesh, septum_tree_i8f8 *tree);

// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
// yes.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used.
septum_answer septum_tree_open_i16f16(const septum_mesh_i16f16 *mesh, septum_tree_i16f16 *tree);

// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
// yes.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used.
septum_answer septum_tree_open_f32(const septum_mesh_f32 *mesh, septum_tree_f32 *tree);

// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
//
// # Safety
// The tree is zero, or was written by `septum_tree_open_i8f8`, and its mesh has not moved.
septum_answer septum_contains_i8f8(const septum_tree_i8f8 *tree, const septum_i8f8 (*point)[3]);

// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
//
// # Safety
// The tree is zero, or was written by `septum_tree_open_i16f16`, and its mesh has not moved.
septum_answer septum_contains_i16f16(const septum_tree_i16f16 *tree, const septum_i16f16 (*point)[3]);

// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
//
// # Safety
// The tree is zero, or was written by `septum_tree_open_f32`, and its mesh has not moved.
septum_answer septum_contains_f32(const septum_tree_f32 *tree, const float (*point)[3]);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SEPTUM_H */
