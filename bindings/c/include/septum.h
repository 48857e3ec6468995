#ifndef SEPTUM_H
#define SEPTUM_H

// Made by cbindgen from bindings/c/src: see bindings/c/README.md.

#include <stddef.h>
#include <stdint.h>

/* A number for each release: 10000 times the major, 100 times the minor, and the patch. */
#define SEPTUM_VERSION 100
#define SEPTUM_VERSION_TEXT "0.1.0"

// An answer, or an error, which is negative: `septum_text` says it in words.
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
  // A ray has the range [0, 0].
  SEPTUM_ANSWER_NO_RANGE = -13,
  // A quaternion has not the length one.
  SEPTUM_ANSWER_NOT_UNIT_QUATERNION = -14,
  // A radius is negative.
  SEPTUM_ANSWER_NEGATIVE_RADIUS = -15,
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

// An oriented box: axes are three unit vectors at right angles to each other.
typedef struct {
  septum_i8f8 center[3];
  septum_i8f8 axes[3][3];
  septum_i8f8 half_extents[3];
} septum_obb_i8f8;

// A ball: all points within the radius of the centre. The radius may be zero.
typedef struct {
  septum_i8f8 center[3];
  septum_i8f8 radius;
} septum_sphere_i8f8;

// All points within the radius of the segment from a to b. The radius may be zero.
typedef struct {
  septum_i8f8 a[3];
  septum_i8f8 b[3];
  septum_i8f8 radius;
} septum_capsule_i8f8;

// The point of a triangle closest to another point, rounded. `feature` says on which vertex or edge
// the exact point lies, in the numbers of a hit.
typedef struct {
  septum_i8f8 point[3];
  uint8_t feature;
} septum_closest_i8f8;

// A ray, from origin + t_min · direction to origin + t_max · direction. The direction may have any
// length except zero. The least number of the type as t_min, and the greatest as t_max, mean an
// unbounded end; in floats these are the infinities. A range of [0, 0], which a structure has that
// was initialised without one, is an error; a segment has [0, 1].
typedef struct {
  septum_i8f8 origin[3];
  septum_i8f8 direction[3];
  septum_i8f8 t_min;
  septum_i8f8 t_max;
} septum_ray_i8f8;

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

// When a moving box first meets a triangle. `t` is the part of the motion until then, from 0 to 1;
// in a type that ends below 1 the greatest number. `normal` is the outward normal of the obstacle,
// of any length; in fixed point it is rounded, and wraps where the product of two edges is beyond the
// type. `axis` is 0, with a normal of zero, if they meet at the start; 1 to 3 for the
// faces of the box, 4 for the triangle's normal, and 5 + 3·i + k for coordinate axis i × edge k.
typedef struct {
  septum_i8f8 t;
  septum_i8f8 normal[3];
  uint8_t axis;
} septum_first_contact_i8f8;

// A point of a contact, on each shape. A part is 0 to 5 for a face, 16 and more for an edge, 32
// and more for a vertex.
typedef struct {
  septum_i8f8 on_first[3];
  septum_i8f8 on_second[3];
  septum_i8f8 depth;
  uint8_t first_part;
  uint8_t second_part;
} septum_point_i8f8;

// The translation that moves the first shape out of the second. Only `point_count` points are
// meant. `is_sufficient` is 0 if a coordinate of the translation is beyond the type. `is_held` is 1
// if an interior edge of a mesh holds it to the triangle's normal.
typedef struct {
  septum_i8f8 translation[3];
  septum_i8f8 depth;
  septum_i8f8 normal[3];
  uint8_t is_sufficient;
  uint8_t is_held;
  uint8_t point_count;
  septum_point_i8f8 points[8];
} septum_contact_i8f8;

// When a moving sphere first meets a triangle or a box. `t` is the part of the motion until then, as
// for a box that moves. `part` is the face, edge or vertex at the point of contact, in the numbers
// of a contact, and 255 if they meet at the start.
typedef struct {
  septum_i8f8 t;
  uint8_t part;
} septum_sphere_contact_i8f8;

// Where a ray enters a shape and leaves it, in units of its direction.
typedef struct {
  septum_i8f8 enter;
  septum_i8f8 leave;
} septum_range_i8f8;

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

// An oriented box: axes are three unit vectors at right angles to each other.
typedef struct {
  septum_i16f16 center[3];
  septum_i16f16 axes[3][3];
  septum_i16f16 half_extents[3];
} septum_obb_i16f16;

// A ball: all points within the radius of the centre. The radius may be zero.
typedef struct {
  septum_i16f16 center[3];
  septum_i16f16 radius;
} septum_sphere_i16f16;

// All points within the radius of the segment from a to b. The radius may be zero.
typedef struct {
  septum_i16f16 a[3];
  septum_i16f16 b[3];
  septum_i16f16 radius;
} septum_capsule_i16f16;

// The point of a triangle closest to another point, rounded. `feature` says on which vertex or edge
// the exact point lies, in the numbers of a hit.
typedef struct {
  septum_i16f16 point[3];
  uint8_t feature;
} septum_closest_i16f16;

// A ray, from origin + t_min · direction to origin + t_max · direction. The direction may have any
// length except zero. The least number of the type as t_min, and the greatest as t_max, mean an
// unbounded end; in floats these are the infinities. A range of [0, 0], which a structure has that
// was initialised without one, is an error; a segment has [0, 1].
typedef struct {
  septum_i16f16 origin[3];
  septum_i16f16 direction[3];
  septum_i16f16 t_min;
  septum_i16f16 t_max;
} septum_ray_i16f16;

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

// When a moving box first meets a triangle. `t` is the part of the motion until then, from 0 to 1;
// in a type that ends below 1 the greatest number. `normal` is the outward normal of the obstacle,
// of any length; in fixed point it is rounded, and wraps where the product of two edges is beyond the
// type. `axis` is 0, with a normal of zero, if they meet at the start; 1 to 3 for the
// faces of the box, 4 for the triangle's normal, and 5 + 3·i + k for coordinate axis i × edge k.
typedef struct {
  septum_i16f16 t;
  septum_i16f16 normal[3];
  uint8_t axis;
} septum_first_contact_i16f16;

// A point of a contact, on each shape. A part is 0 to 5 for a face, 16 and more for an edge, 32
// and more for a vertex.
typedef struct {
  septum_i16f16 on_first[3];
  septum_i16f16 on_second[3];
  septum_i16f16 depth;
  uint8_t first_part;
  uint8_t second_part;
} septum_point_i16f16;

// The translation that moves the first shape out of the second. Only `point_count` points are
// meant. `is_sufficient` is 0 if a coordinate of the translation is beyond the type. `is_held` is 1
// if an interior edge of a mesh holds it to the triangle's normal.
typedef struct {
  septum_i16f16 translation[3];
  septum_i16f16 depth;
  septum_i16f16 normal[3];
  uint8_t is_sufficient;
  uint8_t is_held;
  uint8_t point_count;
  septum_point_i16f16 points[8];
} septum_contact_i16f16;

// When a moving sphere first meets a triangle or a box. `t` is the part of the motion until then, as
// for a box that moves. `part` is the face, edge or vertex at the point of contact, in the numbers
// of a contact, and 255 if they meet at the start.
typedef struct {
  septum_i16f16 t;
  uint8_t part;
} septum_sphere_contact_i16f16;

// Where a ray enters a shape and leaves it, in units of its direction.
typedef struct {
  septum_i16f16 enter;
  septum_i16f16 leave;
} septum_range_i16f16;

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
  float center[3];
  float axes[3][3];
  float half_extents[3];
} septum_obb_f32;

// A ball: all points within the radius of the centre. The radius may be zero.
typedef struct {
  float center[3];
  float radius;
} septum_sphere_f32;

// All points within the radius of the segment from a to b. The radius may be zero.
typedef struct {
  float a[3];
  float b[3];
  float radius;
} septum_capsule_f32;

// The point of a triangle closest to another point, rounded. `feature` says on which vertex or edge
// the exact point lies, in the numbers of a hit.
typedef struct {
  float point[3];
  uint8_t feature;
} septum_closest_f32;

// A ray, from origin + t_min · direction to origin + t_max · direction. The direction may have any
// length except zero. The least number of the type as t_min, and the greatest as t_max, mean an
// unbounded end; in floats these are the infinities. A range of [0, 0], which a structure has that
// was initialised without one, is an error; a segment has [0, 1].
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
  float t;
  float u;
  float v;
  uint8_t is_front;
  uint8_t feature;
} septum_hit_f32;

// When a moving box first meets a triangle. `t` is the part of the motion until then, from 0 to 1;
// in a type that ends below 1 the greatest number. `normal` is the outward normal of the obstacle,
// of any length; in fixed point it is rounded, and wraps where the product of two edges is beyond the
// type. `axis` is 0, with a normal of zero, if they meet at the start; 1 to 3 for the
// faces of the box, 4 for the triangle's normal, and 5 + 3·i + k for coordinate axis i × edge k.
typedef struct {
  float t;
  float normal[3];
  uint8_t axis;
} septum_first_contact_f32;

// A point of a contact, on each shape. A part is 0 to 5 for a face, 16 and more for an edge, 32
// and more for a vertex.
typedef struct {
  float on_first[3];
  float on_second[3];
  float depth;
  uint8_t first_part;
  uint8_t second_part;
} septum_point_f32;

// The translation that moves the first shape out of the second. Only `point_count` points are
// meant. `is_sufficient` is 0 if a coordinate of the translation is beyond the type. `is_held` is 1
// if an interior edge of a mesh holds it to the triangle's normal.
typedef struct {
  float translation[3];
  float depth;
  float normal[3];
  uint8_t is_sufficient;
  uint8_t is_held;
  uint8_t point_count;
  septum_point_f32 points[8];
} septum_contact_f32;

// When a moving sphere first meets a triangle or a box. `t` is the part of the motion until then, as
// for a box that moves. `part` is the face, edge or vertex at the point of contact, in the numbers
// of a contact, and 255 if they meet at the start.
typedef struct {
  float t;
  uint8_t part;
} septum_sphere_contact_f32;

// Where a ray enters a shape and leaves it, in units of its direction.
typedef struct {
  float enter;
  float leave;
} septum_range_f32;

// A triangle. It may be a segment or a point.
typedef struct {
  double a[3];
  double b[3];
  double c[3];
} septum_triangle_f64;

// An axis-aligned box by its least and greatest corner. It may be flat.
typedef struct {
  double min[3];
  double max[3];
} septum_aabb_f64;

// An oriented box: axes are three unit vectors at right angles to each other.
typedef struct {
  double center[3];
  double axes[3][3];
  double half_extents[3];
} septum_obb_f64;

// A ball: all points within the radius of the centre. The radius may be zero.
typedef struct {
  double center[3];
  double radius;
} septum_sphere_f64;

// All points within the radius of the segment from a to b. The radius may be zero.
typedef struct {
  double a[3];
  double b[3];
  double radius;
} septum_capsule_f64;

// The point of a triangle closest to another point, rounded. `feature` says on which vertex or edge
// the exact point lies, in the numbers of a hit.
typedef struct {
  double point[3];
  uint8_t feature;
} septum_closest_f64;

// A ray, from origin + t_min · direction to origin + t_max · direction. The direction may have any
// length except zero. The least number of the type as t_min, and the greatest as t_max, mean an
// unbounded end; in floats these are the infinities. A range of [0, 0], which a structure has that
// was initialised without one, is an error; a segment has [0, 1].
typedef struct {
  double origin[3];
  double direction[3];
  double t_min;
  double t_max;
} septum_ray_f64;

// A hit of a ray on a triangle. `t` is the distance along the ray in units of its direction; `u`
// and `v` are the barycentric coordinates of b and c. `is_front` is 1 if a, b, c go
// counterclockwise seen from the ray's origin. `feature` is 0 for the interior, 1, 2, 3 for the
// edges ab, bc, ca, and 4, 5, 6 for the vertices a, b, c.
typedef struct {
  double t;
  double u;
  double v;
  uint8_t is_front;
  uint8_t feature;
} septum_hit_f64;

// When a moving box first meets a triangle. `t` is the part of the motion until then, from 0 to 1;
// in a type that ends below 1 the greatest number. `normal` is the outward normal of the obstacle,
// of any length; in fixed point it is rounded, and wraps where the product of two edges is beyond the
// type. `axis` is 0, with a normal of zero, if they meet at the start; 1 to 3 for the
// faces of the box, 4 for the triangle's normal, and 5 + 3·i + k for coordinate axis i × edge k.
typedef struct {
  double t;
  double normal[3];
  uint8_t axis;
} septum_first_contact_f64;

// A point of a contact, on each shape. A part is 0 to 5 for a face, 16 and more for an edge, 32
// and more for a vertex.
typedef struct {
  double on_first[3];
  double on_second[3];
  double depth;
  uint8_t first_part;
  uint8_t second_part;
} septum_point_f64;

// The translation that moves the first shape out of the second. Only `point_count` points are
// meant. `is_sufficient` is 0 if a coordinate of the translation is beyond the type. `is_held` is 1
// if an interior edge of a mesh holds it to the triangle's normal.
typedef struct {
  double translation[3];
  double depth;
  double normal[3];
  uint8_t is_sufficient;
  uint8_t is_held;
  uint8_t point_count;
  septum_point_f64 points[8];
} septum_contact_f64;

// When a moving sphere first meets a triangle or a box. `t` is the part of the motion until then, as
// for a box that moves. `part` is the face, edge or vertex at the point of contact, in the numbers
// of a contact, and 255 if they meet at the start.
typedef struct {
  double t;
  uint8_t part;
} septum_sphere_contact_f64;

// Where a ray enters a shape and leaves it, in units of its direction.
typedef struct {
  double enter;
  double leave;
} septum_range_f64;

// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
// vertices; with nodes they are listed in the tree's order. The program in examples/pick writes such
// tables.
typedef struct {
  const septum_i8f8 (*vertices)[3];
  size_t vertex_count;
  const uint16_t (*triangles)[3];
  size_t triangle_count;
  const uint16_t (*nodes)[6][4];
  size_t node_count;
} septum_mesh_i8f8;

// A mesh that has been checked. Only `septum_tree_open` and `septum_tree_build` write one. It may
// be copied, but the mesh must stay where it is.
typedef struct {
  // Private to the library.
  uint64_t opaque[32];
} septum_tree_i8f8;

// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
// vertices; with nodes they are listed in the tree's order. The program in examples/pick writes such
// tables.
typedef struct {
  const septum_i16f16 (*vertices)[3];
  size_t vertex_count;
  const uint16_t (*triangles)[3];
  size_t triangle_count;
  const uint16_t (*nodes)[6][4];
  size_t node_count;
} septum_mesh_i16f16;

// A mesh that has been checked. Only `septum_tree_open` and `septum_tree_build` write one. It may
// be copied, but the mesh must stay where it is.
typedef struct {
  // Private to the library.
  uint64_t opaque[32];
} septum_tree_i16f16;

// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
// vertices; with nodes they are listed in the tree's order. The program in examples/pick writes such
// tables.
typedef struct {
  const float (*vertices)[3];
  size_t vertex_count;
  const uint16_t (*triangles)[3];
  size_t triangle_count;
  const uint16_t (*nodes)[6][4];
  size_t node_count;
} septum_mesh_f32;

// A mesh that has been checked. Only `septum_tree_open` and `septum_tree_build` write one. It may
// be copied, but the mesh must stay where it is.
typedef struct {
  // Private to the library.
  uint64_t opaque[32];
} septum_tree_f32;

// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
// vertices; with nodes they are listed in the tree's order. The program in examples/pick writes such
// tables.
typedef struct {
  const double (*vertices)[3];
  size_t vertex_count;
  const uint16_t (*triangles)[3];
  size_t triangle_count;
  const uint16_t (*nodes)[6][4];
  size_t node_count;
} septum_mesh_f64;

// A mesh that has been checked. Only `septum_tree_open` and `septum_tree_build` write one. It may
// be copied, but the mesh must stay where it is.
typedef struct {
  // Private to the library.
  uint64_t opaque[32];
} septum_tree_f64;

// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
// vertices; with nodes they are listed in the tree's order. The program in examples/pick writes such
// tables.
typedef struct {
  const float (*vertices)[3];
  size_t vertex_count;
  const uint32_t (*triangles)[3];
  size_t triangle_count;
  const uint16_t (*nodes)[6][4];
  size_t node_count;
} septum_mesh32_f32;

// A mesh that has been checked. Only `septum_tree_open` and `septum_tree_build` write one. It may
// be copied, but the mesh must stay where it is.
typedef struct {
  // Private to the library.
  uint64_t opaque[32];
} septum_tree32_f32;

// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
// vertices; with nodes they are listed in the tree's order. The program in examples/pick writes such
// tables.
typedef struct {
  const double (*vertices)[3];
  size_t vertex_count;
  const uint32_t (*triangles)[3];
  size_t triangle_count;
  const uint16_t (*nodes)[6][4];
  size_t node_count;
} septum_mesh32_f64;

// A mesh that has been checked. Only `septum_tree_open` and `septum_tree_build` write one. It may
// be copied, but the mesh must stay where it is.
typedef struct {
  // Private to the library.
  uint64_t opaque[32];
} septum_tree32_f64;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// An answer in words, for a log. It stays.
const char *septum_text(int32_t answer);

// How many nodes the tree over so many triangles has.
size_t septum_node_count(size_t triangles);

// Whether a triangle overlaps an axis-aligned box, exactly.
septum_answer septum_triangle_aabb_i8f8(const septum_triangle_i8f8 *triangle, const septum_aabb_i8f8 *aabb);

// Whether a triangle overlaps an oriented box, exactly for the numbers given.
septum_answer septum_triangle_obb_i8f8(const septum_triangle_i8f8 *triangle, const septum_obb_i8f8 *obb);

// Whether two triangles overlap, exactly.
septum_answer septum_triangle_triangle_i8f8(const septum_triangle_i8f8 *first, const septum_triangle_i8f8 *second);

// Whether a sphere overlaps a triangle, exactly.
septum_answer septum_sphere_triangle_i8f8(const septum_sphere_i8f8 *sphere, const septum_triangle_i8f8 *triangle);

// Whether a sphere overlaps an axis-aligned box, exactly.
septum_answer septum_sphere_aabb_i8f8(const septum_sphere_i8f8 *sphere, const septum_aabb_i8f8 *aabb);

// Whether a capsule overlaps a triangle, exactly.
septum_answer septum_capsule_triangle_i8f8(const septum_capsule_i8f8 *capsule, const septum_triangle_i8f8 *triangle);

// Whether a capsule overlaps an axis-aligned box, exactly.
septum_answer septum_capsule_aabb_i8f8(const septum_capsule_i8f8 *capsule, const septum_aabb_i8f8 *aabb);

// Writes the point of a triangle closest to a point, each coordinate rounded once: yes, or the
// error.
//
// # Safety
// `point` leads to three numbers.
septum_answer septum_triangle_closest_point_i8f8(const septum_triangle_i8f8 *triangle, const septum_i8f8 *point, septum_closest_i8f8 *closest);

// Whether a ray meets an axis-aligned box, exactly.
septum_answer septum_ray_aabb_i8f8(const septum_ray_i8f8 *ray, const septum_aabb_i8f8 *aabb);

// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
septum_answer septum_ray_triangle_i8f8(const septum_ray_i8f8 *ray, const septum_triangle_i8f8 *triangle);

// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in floats.
septum_answer septum_ray_triangle_hit_i8f8(const septum_ray_i8f8 *ray, const septum_triangle_i8f8 *triangle, septum_hit_i8f8 *hit);

// When a box that moves by `motion` first meets a triangle; writes `first` only if the answer is
// yes. The verdict is exact, and the time is never late.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_aabb_cast_triangle_i8f8(const septum_aabb_i8f8 *aabb, const septum_i8f8 *motion, const septum_triangle_i8f8 *triangle, septum_first_contact_i8f8 *first);

// The least translation that moves a triangle out of a box, and where they meet; writes `contact`
// only if the answer is yes. Shapes that only touch have no contact.
septum_answer septum_triangle_aabb_contact_i8f8(const septum_triangle_i8f8 *triangle, const septum_aabb_i8f8 *aabb, septum_contact_i8f8 *contact);

// The same of two oriented boxes: of the first out of the second.
septum_answer septum_obb_obb_contact_i8f8(const septum_obb_i8f8 *first, const septum_obb_i8f8 *second, septum_contact_i8f8 *contact);

// The same of a sphere and a triangle: of the sphere out of the triangle, with one point.
septum_answer septum_sphere_triangle_contact_i8f8(const septum_sphere_i8f8 *sphere, const septum_triangle_i8f8 *triangle, septum_contact_i8f8 *contact);

// The same of a sphere and an axis-aligned box.
septum_answer septum_sphere_aabb_contact_i8f8(const septum_sphere_i8f8 *sphere, const septum_aabb_i8f8 *aabb, septum_contact_i8f8 *contact);

// The same of a capsule and a triangle.
septum_answer septum_capsule_triangle_contact_i8f8(const septum_capsule_i8f8 *capsule, const septum_triangle_i8f8 *triangle, septum_contact_i8f8 *contact);

// The same of a capsule and an axis-aligned box.
septum_answer septum_capsule_aabb_contact_i8f8(const septum_capsule_i8f8 *capsule, const septum_aabb_i8f8 *aabb, septum_contact_i8f8 *contact);

// When a sphere that moves by `motion` first meets a triangle; writes `first` only if the answer is
// yes. The verdict is exact, and the time is never late.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_sphere_cast_triangle_i8f8(const septum_sphere_i8f8 *sphere, const septum_i8f8 *motion, const septum_triangle_i8f8 *triangle, septum_sphere_contact_i8f8 *first);

// The same past an axis-aligned box.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_sphere_cast_aabb_i8f8(const septum_sphere_i8f8 *sphere, const septum_i8f8 *motion, const septum_aabb_i8f8 *aabb, septum_sphere_contact_i8f8 *first);

// Where a ray enters a sphere and leaves it; writes `range` only if the answer is yes. The verdict is
// exact; both numbers are rounded outward.
septum_answer septum_ray_sphere_range_i8f8(const septum_ray_i8f8 *ray, const septum_sphere_i8f8 *sphere, septum_range_i8f8 *range);

// Writes the axes of a box that is turned by a unit quaternion x, y, z, w. Its centre and its
// half-extents must be set.
//
// # Safety
// `quaternion` leads to four numbers.
septum_answer septum_obb_turn_i8f8(septum_obb_i8f8 *obb, const septum_i8f8 *quaternion);

// Whether a triangle overlaps an axis-aligned box, exactly.
septum_answer septum_triangle_aabb_i16f16(const septum_triangle_i16f16 *triangle, const septum_aabb_i16f16 *aabb);

// Whether a triangle overlaps an oriented box, exactly for the numbers given.
septum_answer septum_triangle_obb_i16f16(const septum_triangle_i16f16 *triangle, const septum_obb_i16f16 *obb);

// Whether two triangles overlap, exactly.
septum_answer septum_triangle_triangle_i16f16(const septum_triangle_i16f16 *first, const septum_triangle_i16f16 *second);

// Whether a sphere overlaps a triangle, exactly.
septum_answer septum_sphere_triangle_i16f16(const septum_sphere_i16f16 *sphere, const septum_triangle_i16f16 *triangle);

// Whether a sphere overlaps an axis-aligned box, exactly.
septum_answer septum_sphere_aabb_i16f16(const septum_sphere_i16f16 *sphere, const septum_aabb_i16f16 *aabb);

// Whether a capsule overlaps a triangle, exactly.
septum_answer septum_capsule_triangle_i16f16(const septum_capsule_i16f16 *capsule, const septum_triangle_i16f16 *triangle);

// Whether a capsule overlaps an axis-aligned box, exactly.
septum_answer septum_capsule_aabb_i16f16(const septum_capsule_i16f16 *capsule, const septum_aabb_i16f16 *aabb);

// Writes the point of a triangle closest to a point, each coordinate rounded once: yes, or the
// error.
//
// # Safety
// `point` leads to three numbers.
septum_answer septum_triangle_closest_point_i16f16(const septum_triangle_i16f16 *triangle, const septum_i16f16 *point, septum_closest_i16f16 *closest);

// Whether a ray meets an axis-aligned box, exactly.
septum_answer septum_ray_aabb_i16f16(const septum_ray_i16f16 *ray, const septum_aabb_i16f16 *aabb);

// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
septum_answer septum_ray_triangle_i16f16(const septum_ray_i16f16 *ray, const septum_triangle_i16f16 *triangle);

// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in floats.
septum_answer septum_ray_triangle_hit_i16f16(const septum_ray_i16f16 *ray, const septum_triangle_i16f16 *triangle, septum_hit_i16f16 *hit);

// When a box that moves by `motion` first meets a triangle; writes `first` only if the answer is
// yes. The verdict is exact, and the time is never late.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_aabb_cast_triangle_i16f16(const septum_aabb_i16f16 *aabb, const septum_i16f16 *motion, const septum_triangle_i16f16 *triangle, septum_first_contact_i16f16 *first);

// The least translation that moves a triangle out of a box, and where they meet; writes `contact`
// only if the answer is yes. Shapes that only touch have no contact.
septum_answer septum_triangle_aabb_contact_i16f16(const septum_triangle_i16f16 *triangle, const septum_aabb_i16f16 *aabb, septum_contact_i16f16 *contact);

// The same of two oriented boxes: of the first out of the second.
septum_answer septum_obb_obb_contact_i16f16(const septum_obb_i16f16 *first, const septum_obb_i16f16 *second, septum_contact_i16f16 *contact);

// The same of a sphere and a triangle: of the sphere out of the triangle, with one point.
septum_answer septum_sphere_triangle_contact_i16f16(const septum_sphere_i16f16 *sphere, const septum_triangle_i16f16 *triangle, septum_contact_i16f16 *contact);

// The same of a sphere and an axis-aligned box.
septum_answer septum_sphere_aabb_contact_i16f16(const septum_sphere_i16f16 *sphere, const septum_aabb_i16f16 *aabb, septum_contact_i16f16 *contact);

// The same of a capsule and a triangle.
septum_answer septum_capsule_triangle_contact_i16f16(const septum_capsule_i16f16 *capsule, const septum_triangle_i16f16 *triangle, septum_contact_i16f16 *contact);

// The same of a capsule and an axis-aligned box.
septum_answer septum_capsule_aabb_contact_i16f16(const septum_capsule_i16f16 *capsule, const septum_aabb_i16f16 *aabb, septum_contact_i16f16 *contact);

// When a sphere that moves by `motion` first meets a triangle; writes `first` only if the answer is
// yes. The verdict is exact, and the time is never late.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_sphere_cast_triangle_i16f16(const septum_sphere_i16f16 *sphere, const septum_i16f16 *motion, const septum_triangle_i16f16 *triangle, septum_sphere_contact_i16f16 *first);

// The same past an axis-aligned box.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_sphere_cast_aabb_i16f16(const septum_sphere_i16f16 *sphere, const septum_i16f16 *motion, const septum_aabb_i16f16 *aabb, septum_sphere_contact_i16f16 *first);

// Where a ray enters a sphere and leaves it; writes `range` only if the answer is yes. The verdict is
// exact; both numbers are rounded outward.
septum_answer septum_ray_sphere_range_i16f16(const septum_ray_i16f16 *ray, const septum_sphere_i16f16 *sphere, septum_range_i16f16 *range);

// Writes the axes of a box that is turned by a unit quaternion x, y, z, w. Its centre and its
// half-extents must be set.
//
// # Safety
// `quaternion` leads to four numbers.
septum_answer septum_obb_turn_i16f16(septum_obb_i16f16 *obb, const septum_i16f16 *quaternion);

// Whether a triangle overlaps an axis-aligned box, exactly.
septum_answer septum_triangle_aabb_f32(const septum_triangle_f32 *triangle, const septum_aabb_f32 *aabb);

// Whether a triangle overlaps an oriented box, exactly for the numbers given.
septum_answer septum_triangle_obb_f32(const septum_triangle_f32 *triangle, const septum_obb_f32 *obb);

// Whether two triangles overlap, exactly.
septum_answer septum_triangle_triangle_f32(const septum_triangle_f32 *first, const septum_triangle_f32 *second);

// Whether a sphere overlaps a triangle, exactly.
septum_answer septum_sphere_triangle_f32(const septum_sphere_f32 *sphere, const septum_triangle_f32 *triangle);

// Whether a sphere overlaps an axis-aligned box, exactly.
septum_answer septum_sphere_aabb_f32(const septum_sphere_f32 *sphere, const septum_aabb_f32 *aabb);

// Whether a capsule overlaps a triangle, exactly.
septum_answer septum_capsule_triangle_f32(const septum_capsule_f32 *capsule, const septum_triangle_f32 *triangle);

// Whether a capsule overlaps an axis-aligned box, exactly.
septum_answer septum_capsule_aabb_f32(const septum_capsule_f32 *capsule, const septum_aabb_f32 *aabb);

// Writes the point of a triangle closest to a point, each coordinate rounded once: yes, or the
// error.
//
// # Safety
// `point` leads to three numbers.
septum_answer septum_triangle_closest_point_f32(const septum_triangle_f32 *triangle, const float *point, septum_closest_f32 *closest);

// Whether a ray meets an axis-aligned box, exactly.
septum_answer septum_ray_aabb_f32(const septum_ray_f32 *ray, const septum_aabb_f32 *aabb);

// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
septum_answer septum_ray_triangle_f32(const septum_ray_f32 *ray, const septum_triangle_f32 *triangle);

// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in floats.
septum_answer septum_ray_triangle_hit_f32(const septum_ray_f32 *ray, const septum_triangle_f32 *triangle, septum_hit_f32 *hit);

// When a box that moves by `motion` first meets a triangle; writes `first` only if the answer is
// yes. The verdict is exact, and the time is never late.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_aabb_cast_triangle_f32(const septum_aabb_f32 *aabb, const float *motion, const septum_triangle_f32 *triangle, septum_first_contact_f32 *first);

// The least translation that moves a triangle out of a box, and where they meet; writes `contact`
// only if the answer is yes. Shapes that only touch have no contact.
septum_answer septum_triangle_aabb_contact_f32(const septum_triangle_f32 *triangle, const septum_aabb_f32 *aabb, septum_contact_f32 *contact);

// The same of two oriented boxes: of the first out of the second.
septum_answer septum_obb_obb_contact_f32(const septum_obb_f32 *first, const septum_obb_f32 *second, septum_contact_f32 *contact);

// The same of a sphere and a triangle: of the sphere out of the triangle, with one point.
septum_answer septum_sphere_triangle_contact_f32(const septum_sphere_f32 *sphere, const septum_triangle_f32 *triangle, septum_contact_f32 *contact);

// The same of a sphere and an axis-aligned box.
septum_answer septum_sphere_aabb_contact_f32(const septum_sphere_f32 *sphere, const septum_aabb_f32 *aabb, septum_contact_f32 *contact);

// The same of a capsule and a triangle.
septum_answer septum_capsule_triangle_contact_f32(const septum_capsule_f32 *capsule, const septum_triangle_f32 *triangle, septum_contact_f32 *contact);

// The same of a capsule and an axis-aligned box.
septum_answer septum_capsule_aabb_contact_f32(const septum_capsule_f32 *capsule, const septum_aabb_f32 *aabb, septum_contact_f32 *contact);

// When a sphere that moves by `motion` first meets a triangle; writes `first` only if the answer is
// yes. The verdict is exact, and the time is never late.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_sphere_cast_triangle_f32(const septum_sphere_f32 *sphere, const float *motion, const septum_triangle_f32 *triangle, septum_sphere_contact_f32 *first);

// The same past an axis-aligned box.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_sphere_cast_aabb_f32(const septum_sphere_f32 *sphere, const float *motion, const septum_aabb_f32 *aabb, septum_sphere_contact_f32 *first);

// Where a ray enters a sphere and leaves it; writes `range` only if the answer is yes. The verdict is
// exact; both numbers are rounded outward.
septum_answer septum_ray_sphere_range_f32(const septum_ray_f32 *ray, const septum_sphere_f32 *sphere, septum_range_f32 *range);

// Writes the axes of a box that is turned by a unit quaternion x, y, z, w. Its centre and its
// half-extents must be set.
//
// # Safety
// `quaternion` leads to four numbers.
septum_answer septum_obb_turn_f32(septum_obb_f32 *obb, const float *quaternion);

// Whether a triangle overlaps an axis-aligned box, exactly.
septum_answer septum_triangle_aabb_f64(const septum_triangle_f64 *triangle, const septum_aabb_f64 *aabb);

// Whether a triangle overlaps an oriented box, exactly for the numbers given.
septum_answer septum_triangle_obb_f64(const septum_triangle_f64 *triangle, const septum_obb_f64 *obb);

// Whether two triangles overlap, exactly.
septum_answer septum_triangle_triangle_f64(const septum_triangle_f64 *first, const septum_triangle_f64 *second);

// Whether a sphere overlaps a triangle, exactly.
septum_answer septum_sphere_triangle_f64(const septum_sphere_f64 *sphere, const septum_triangle_f64 *triangle);

// Whether a sphere overlaps an axis-aligned box, exactly.
septum_answer septum_sphere_aabb_f64(const septum_sphere_f64 *sphere, const septum_aabb_f64 *aabb);

// Whether a capsule overlaps a triangle, exactly.
septum_answer septum_capsule_triangle_f64(const septum_capsule_f64 *capsule, const septum_triangle_f64 *triangle);

// Whether a capsule overlaps an axis-aligned box, exactly.
septum_answer septum_capsule_aabb_f64(const septum_capsule_f64 *capsule, const septum_aabb_f64 *aabb);

// Writes the point of a triangle closest to a point, each coordinate rounded once: yes, or the
// error.
//
// # Safety
// `point` leads to three numbers.
septum_answer septum_triangle_closest_point_f64(const septum_triangle_f64 *triangle, const double *point, septum_closest_f64 *closest);

// Whether a ray meets an axis-aligned box, exactly.
septum_answer septum_ray_aabb_f64(const septum_ray_f64 *ray, const septum_aabb_f64 *aabb);

// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
septum_answer septum_ray_triangle_f64(const septum_ray_f64 *ray, const septum_triangle_f64 *triangle);

// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in floats.
septum_answer septum_ray_triangle_hit_f64(const septum_ray_f64 *ray, const septum_triangle_f64 *triangle, septum_hit_f64 *hit);

// When a box that moves by `motion` first meets a triangle; writes `first` only if the answer is
// yes. The verdict is exact, and the time is never late.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_aabb_cast_triangle_f64(const septum_aabb_f64 *aabb, const double *motion, const septum_triangle_f64 *triangle, septum_first_contact_f64 *first);

// The least translation that moves a triangle out of a box, and where they meet; writes `contact`
// only if the answer is yes. Shapes that only touch have no contact.
septum_answer septum_triangle_aabb_contact_f64(const septum_triangle_f64 *triangle, const septum_aabb_f64 *aabb, septum_contact_f64 *contact);

// The same of two oriented boxes: of the first out of the second.
septum_answer septum_obb_obb_contact_f64(const septum_obb_f64 *first, const septum_obb_f64 *second, septum_contact_f64 *contact);

// The same of a sphere and a triangle: of the sphere out of the triangle, with one point.
septum_answer septum_sphere_triangle_contact_f64(const septum_sphere_f64 *sphere, const septum_triangle_f64 *triangle, septum_contact_f64 *contact);

// The same of a sphere and an axis-aligned box.
septum_answer septum_sphere_aabb_contact_f64(const septum_sphere_f64 *sphere, const septum_aabb_f64 *aabb, septum_contact_f64 *contact);

// The same of a capsule and a triangle.
septum_answer septum_capsule_triangle_contact_f64(const septum_capsule_f64 *capsule, const septum_triangle_f64 *triangle, septum_contact_f64 *contact);

// The same of a capsule and an axis-aligned box.
septum_answer septum_capsule_aabb_contact_f64(const septum_capsule_f64 *capsule, const septum_aabb_f64 *aabb, septum_contact_f64 *contact);

// When a sphere that moves by `motion` first meets a triangle; writes `first` only if the answer is
// yes. The verdict is exact, and the time is never late.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_sphere_cast_triangle_f64(const septum_sphere_f64 *sphere, const double *motion, const septum_triangle_f64 *triangle, septum_sphere_contact_f64 *first);

// The same past an axis-aligned box.
//
// # Safety
// `motion` leads to three numbers.
septum_answer septum_sphere_cast_aabb_f64(const septum_sphere_f64 *sphere, const double *motion, const septum_aabb_f64 *aabb, septum_sphere_contact_f64 *first);

// Where a ray enters a sphere and leaves it; writes `range` only if the answer is yes. The verdict is
// exact; both numbers are rounded outward.
septum_answer septum_ray_sphere_range_f64(const septum_ray_f64 *ray, const septum_sphere_f64 *sphere, septum_range_f64 *range);

// Writes the axes of a box that is turned by a unit quaternion x, y, z, w. Its centre and its
// half-extents must be set.
//
// # Safety
// `quaternion` leads to four numbers.
septum_answer septum_obb_turn_f64(septum_obb_f64 *obb, const double *quaternion);

// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
// yes.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used.
septum_answer septum_tree_open_i8f8(const septum_mesh_i8f8 *mesh, septum_tree_i8f8 *tree);

// Builds a tree over a mesh, whose own nodes are not looked at, in the memory of `nodes`, as many
// as [`septum_node_count`] says, and of `order`, an index for each triangle: yes, or the error. All
// three stay where they are for as long as the tree is used. Triangles keep their numbers.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used. `nodes` has `node_count` elements, and `order` one for each triangle.
septum_answer septum_tree_build_i8f8(const septum_mesh_i8f8 *mesh, uint16_t (*nodes)[6][4], size_t node_count, uint16_t *order, septum_tree_i8f8 *tree);

// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree_contains_i8f8(const septum_tree_i8f8 *tree, const septum_i8f8 *point);

// The first triangle that a ray hits, and the hit: written only if the answer is yes. Exact, as for
// a single triangle; of several at one point the least triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_first_hit_i8f8(const septum_tree_i8f8 *tree, const septum_ray_i8f8 *ray, size_t *triangle, septum_hit_i8f8 *hit);

// Whether a ray hits any triangle, exactly.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_is_hit_i8f8(const septum_tree_i8f8 *tree, const septum_ray_i8f8 *ray);

// Whether a box overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_aabb_i8f8(const septum_tree_i8f8 *tree, const septum_aabb_i8f8 *aabb, size_t *triangle);

// Whether a sphere overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_sphere_i8f8(const septum_tree_i8f8 *tree, const septum_sphere_i8f8 *sphere, size_t *triangle);

// The triangle closest to a point, exactly, and its point, rounded; of several at one distance the
// least triangle. No if the mesh is empty.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree_closest_point_i8f8(const septum_tree_i8f8 *tree, const septum_i8f8 *point, size_t *triangle, septum_closest_i8f8 *closest);

// The first triangle that a box meets as it moves by `motion`, and when: written only if the answer
// is yes. The verdict is exact, and the time is never late.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree_aabb_cast_i8f8(const septum_tree_i8f8 *tree, const septum_aabb_i8f8 *aabb, const septum_i8f8 *motion, size_t *triangle, septum_first_contact_i8f8 *first);

// The same of a sphere.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree_sphere_cast_i8f8(const septum_tree_i8f8 *tree, const septum_sphere_i8f8 *sphere, const septum_i8f8 *motion, size_t *triangle, septum_sphere_contact_i8f8 *first);

// Writes which edges of each triangle are interior: bit k of `interior` for the edge from vertex k
// to the next. Nothing is to catch on these. `scratch` has three elements for each triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `scratch` has three elements for each triangle, and `interior` one.
septum_answer septum_tree_interior_edges_i8f8(const septum_tree_i8f8 *tree, uint16_t (*scratch)[2], uint8_t *interior);

// The contacts of a sphere with all triangles that it penetrates, in the tree's order, and the
// numbers of these: as many as `count` says, which then says how many there are. Each translation
// moves the triangle; the sphere moves by its opposite. `interior` may be null.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `interior` is null, or has an element for each triangle; `triangles` and `contacts` have `count`
// elements.
septum_answer septum_tree_sphere_contacts_i8f8(const septum_tree_i8f8 *tree, const septum_sphere_i8f8 *sphere, const uint8_t *interior, size_t *triangles, septum_contact_i8f8 *contacts, size_t *count);

// The same of a capsule.
//
// # Safety
// As for `septum_tree_sphere_contacts_i8f8`.
septum_answer septum_tree_capsule_contacts_i8f8(const septum_tree_i8f8 *tree, const septum_capsule_i8f8 *capsule, const uint8_t *interior, size_t *triangles, septum_contact_i8f8 *contacts, size_t *count);

// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
// yes.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used.
septum_answer septum_tree_open_i16f16(const septum_mesh_i16f16 *mesh, septum_tree_i16f16 *tree);

// Builds a tree over a mesh, whose own nodes are not looked at, in the memory of `nodes`, as many
// as [`septum_node_count`] says, and of `order`, an index for each triangle: yes, or the error. All
// three stay where they are for as long as the tree is used. Triangles keep their numbers.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used. `nodes` has `node_count` elements, and `order` one for each triangle.
septum_answer septum_tree_build_i16f16(const septum_mesh_i16f16 *mesh, uint16_t (*nodes)[6][4], size_t node_count, uint16_t *order, septum_tree_i16f16 *tree);

// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree_contains_i16f16(const septum_tree_i16f16 *tree, const septum_i16f16 *point);

// The first triangle that a ray hits, and the hit: written only if the answer is yes. Exact, as for
// a single triangle; of several at one point the least triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_first_hit_i16f16(const septum_tree_i16f16 *tree, const septum_ray_i16f16 *ray, size_t *triangle, septum_hit_i16f16 *hit);

// Whether a ray hits any triangle, exactly.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_is_hit_i16f16(const septum_tree_i16f16 *tree, const septum_ray_i16f16 *ray);

// Whether a box overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_aabb_i16f16(const septum_tree_i16f16 *tree, const septum_aabb_i16f16 *aabb, size_t *triangle);

// Whether a sphere overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_sphere_i16f16(const septum_tree_i16f16 *tree, const septum_sphere_i16f16 *sphere, size_t *triangle);

// The triangle closest to a point, exactly, and its point, rounded; of several at one distance the
// least triangle. No if the mesh is empty.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree_closest_point_i16f16(const septum_tree_i16f16 *tree, const septum_i16f16 *point, size_t *triangle, septum_closest_i16f16 *closest);

// The first triangle that a box meets as it moves by `motion`, and when: written only if the answer
// is yes. The verdict is exact, and the time is never late.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree_aabb_cast_i16f16(const septum_tree_i16f16 *tree, const septum_aabb_i16f16 *aabb, const septum_i16f16 *motion, size_t *triangle, septum_first_contact_i16f16 *first);

// The same of a sphere.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree_sphere_cast_i16f16(const septum_tree_i16f16 *tree, const septum_sphere_i16f16 *sphere, const septum_i16f16 *motion, size_t *triangle, septum_sphere_contact_i16f16 *first);

// Writes which edges of each triangle are interior: bit k of `interior` for the edge from vertex k
// to the next. Nothing is to catch on these. `scratch` has three elements for each triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `scratch` has three elements for each triangle, and `interior` one.
septum_answer septum_tree_interior_edges_i16f16(const septum_tree_i16f16 *tree, uint16_t (*scratch)[2], uint8_t *interior);

// The contacts of a sphere with all triangles that it penetrates, in the tree's order, and the
// numbers of these: as many as `count` says, which then says how many there are. Each translation
// moves the triangle; the sphere moves by its opposite. `interior` may be null.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `interior` is null, or has an element for each triangle; `triangles` and `contacts` have `count`
// elements.
septum_answer septum_tree_sphere_contacts_i16f16(const septum_tree_i16f16 *tree, const septum_sphere_i16f16 *sphere, const uint8_t *interior, size_t *triangles, septum_contact_i16f16 *contacts, size_t *count);

// The same of a capsule.
//
// # Safety
// As for `septum_tree_sphere_contacts_i16f16`.
septum_answer septum_tree_capsule_contacts_i16f16(const septum_tree_i16f16 *tree, const septum_capsule_i16f16 *capsule, const uint8_t *interior, size_t *triangles, septum_contact_i16f16 *contacts, size_t *count);

// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
// yes.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used.
septum_answer septum_tree_open_f32(const septum_mesh_f32 *mesh, septum_tree_f32 *tree);

// Builds a tree over a mesh, whose own nodes are not looked at, in the memory of `nodes`, as many
// as [`septum_node_count`] says, and of `order`, an index for each triangle: yes, or the error. All
// three stay where they are for as long as the tree is used. Triangles keep their numbers.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used. `nodes` has `node_count` elements, and `order` one for each triangle.
septum_answer septum_tree_build_f32(const septum_mesh_f32 *mesh, uint16_t (*nodes)[6][4], size_t node_count, uint16_t *order, septum_tree_f32 *tree);

// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree_contains_f32(const septum_tree_f32 *tree, const float *point);

// The first triangle that a ray hits, and the hit: written only if the answer is yes. Exact, as for
// a single triangle; of several at one point the least triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_first_hit_f32(const septum_tree_f32 *tree, const septum_ray_f32 *ray, size_t *triangle, septum_hit_f32 *hit);

// Whether a ray hits any triangle, exactly.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_is_hit_f32(const septum_tree_f32 *tree, const septum_ray_f32 *ray);

// Whether a box overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_aabb_f32(const septum_tree_f32 *tree, const septum_aabb_f32 *aabb, size_t *triangle);

// Whether a sphere overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_sphere_f32(const septum_tree_f32 *tree, const septum_sphere_f32 *sphere, size_t *triangle);

// The triangle closest to a point, exactly, and its point, rounded; of several at one distance the
// least triangle. No if the mesh is empty.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree_closest_point_f32(const septum_tree_f32 *tree, const float *point, size_t *triangle, septum_closest_f32 *closest);

// The first triangle that a box meets as it moves by `motion`, and when: written only if the answer
// is yes. The verdict is exact, and the time is never late.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree_aabb_cast_f32(const septum_tree_f32 *tree, const septum_aabb_f32 *aabb, const float *motion, size_t *triangle, septum_first_contact_f32 *first);

// The same of a sphere.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree_sphere_cast_f32(const septum_tree_f32 *tree, const septum_sphere_f32 *sphere, const float *motion, size_t *triangle, septum_sphere_contact_f32 *first);

// Writes which edges of each triangle are interior: bit k of `interior` for the edge from vertex k
// to the next. Nothing is to catch on these. `scratch` has three elements for each triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `scratch` has three elements for each triangle, and `interior` one.
septum_answer septum_tree_interior_edges_f32(const septum_tree_f32 *tree, uint16_t (*scratch)[2], uint8_t *interior);

// The contacts of a sphere with all triangles that it penetrates, in the tree's order, and the
// numbers of these: as many as `count` says, which then says how many there are. Each translation
// moves the triangle; the sphere moves by its opposite. `interior` may be null.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `interior` is null, or has an element for each triangle; `triangles` and `contacts` have `count`
// elements.
septum_answer septum_tree_sphere_contacts_f32(const septum_tree_f32 *tree, const septum_sphere_f32 *sphere, const uint8_t *interior, size_t *triangles, septum_contact_f32 *contacts, size_t *count);

// The same of a capsule.
//
// # Safety
// As for `septum_tree_sphere_contacts_f32`.
septum_answer septum_tree_capsule_contacts_f32(const septum_tree_f32 *tree, const septum_capsule_f32 *capsule, const uint8_t *interior, size_t *triangles, septum_contact_f32 *contacts, size_t *count);

// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
// yes.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used.
septum_answer septum_tree_open_f64(const septum_mesh_f64 *mesh, septum_tree_f64 *tree);

// Builds a tree over a mesh, whose own nodes are not looked at, in the memory of `nodes`, as many
// as [`septum_node_count`] says, and of `order`, an index for each triangle: yes, or the error. All
// three stay where they are for as long as the tree is used. Triangles keep their numbers.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used. `nodes` has `node_count` elements, and `order` one for each triangle.
septum_answer septum_tree_build_f64(const septum_mesh_f64 *mesh, uint16_t (*nodes)[6][4], size_t node_count, uint16_t *order, septum_tree_f64 *tree);

// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree_contains_f64(const septum_tree_f64 *tree, const double *point);

// The first triangle that a ray hits, and the hit: written only if the answer is yes. Exact, as for
// a single triangle; of several at one point the least triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_first_hit_f64(const septum_tree_f64 *tree, const septum_ray_f64 *ray, size_t *triangle, septum_hit_f64 *hit);

// Whether a ray hits any triangle, exactly.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_is_hit_f64(const septum_tree_f64 *tree, const septum_ray_f64 *ray);

// Whether a box overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_aabb_f64(const septum_tree_f64 *tree, const septum_aabb_f64 *aabb, size_t *triangle);

// Whether a sphere overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree_sphere_f64(const septum_tree_f64 *tree, const septum_sphere_f64 *sphere, size_t *triangle);

// The triangle closest to a point, exactly, and its point, rounded; of several at one distance the
// least triangle. No if the mesh is empty.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree_closest_point_f64(const septum_tree_f64 *tree, const double *point, size_t *triangle, septum_closest_f64 *closest);

// The first triangle that a box meets as it moves by `motion`, and when: written only if the answer
// is yes. The verdict is exact, and the time is never late.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree_aabb_cast_f64(const septum_tree_f64 *tree, const septum_aabb_f64 *aabb, const double *motion, size_t *triangle, septum_first_contact_f64 *first);

// The same of a sphere.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree_sphere_cast_f64(const septum_tree_f64 *tree, const septum_sphere_f64 *sphere, const double *motion, size_t *triangle, septum_sphere_contact_f64 *first);

// Writes which edges of each triangle are interior: bit k of `interior` for the edge from vertex k
// to the next. Nothing is to catch on these. `scratch` has three elements for each triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `scratch` has three elements for each triangle, and `interior` one.
septum_answer septum_tree_interior_edges_f64(const septum_tree_f64 *tree, uint16_t (*scratch)[2], uint8_t *interior);

// The contacts of a sphere with all triangles that it penetrates, in the tree's order, and the
// numbers of these: as many as `count` says, which then says how many there are. Each translation
// moves the triangle; the sphere moves by its opposite. `interior` may be null.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `interior` is null, or has an element for each triangle; `triangles` and `contacts` have `count`
// elements.
septum_answer septum_tree_sphere_contacts_f64(const septum_tree_f64 *tree, const septum_sphere_f64 *sphere, const uint8_t *interior, size_t *triangles, septum_contact_f64 *contacts, size_t *count);

// The same of a capsule.
//
// # Safety
// As for `septum_tree_sphere_contacts_f64`.
septum_answer septum_tree_capsule_contacts_f64(const septum_tree_f64 *tree, const septum_capsule_f64 *capsule, const uint8_t *interior, size_t *triangles, septum_contact_f64 *contacts, size_t *count);

// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
// yes.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used.
septum_answer septum_tree32_open_f32(const septum_mesh32_f32 *mesh, septum_tree32_f32 *tree);

// Builds a tree over a mesh, whose own nodes are not looked at, in the memory of `nodes`, as many
// as [`septum_node_count`] says, and of `order`, an index for each triangle: yes, or the error. All
// three stay where they are for as long as the tree is used. Triangles keep their numbers.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used. `nodes` has `node_count` elements, and `order` one for each triangle.
septum_answer septum_tree32_build_f32(const septum_mesh32_f32 *mesh, uint16_t (*nodes)[6][4], size_t node_count, uint32_t *order, septum_tree32_f32 *tree);

// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree32_contains_f32(const septum_tree32_f32 *tree, const float *point);

// The first triangle that a ray hits, and the hit: written only if the answer is yes. Exact, as for
// a single triangle; of several at one point the least triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree32_first_hit_f32(const septum_tree32_f32 *tree, const septum_ray_f32 *ray, size_t *triangle, septum_hit_f32 *hit);

// Whether a ray hits any triangle, exactly.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree32_is_hit_f32(const septum_tree32_f32 *tree, const septum_ray_f32 *ray);

// Whether a box overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree32_aabb_f32(const septum_tree32_f32 *tree, const septum_aabb_f32 *aabb, size_t *triangle);

// Whether a sphere overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree32_sphere_f32(const septum_tree32_f32 *tree, const septum_sphere_f32 *sphere, size_t *triangle);

// The triangle closest to a point, exactly, and its point, rounded; of several at one distance the
// least triangle. No if the mesh is empty.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree32_closest_point_f32(const septum_tree32_f32 *tree, const float *point, size_t *triangle, septum_closest_f32 *closest);

// The first triangle that a box meets as it moves by `motion`, and when: written only if the answer
// is yes. The verdict is exact, and the time is never late.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree32_aabb_cast_f32(const septum_tree32_f32 *tree, const septum_aabb_f32 *aabb, const float *motion, size_t *triangle, septum_first_contact_f32 *first);

// The same of a sphere.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree32_sphere_cast_f32(const septum_tree32_f32 *tree, const septum_sphere_f32 *sphere, const float *motion, size_t *triangle, septum_sphere_contact_f32 *first);

// Writes which edges of each triangle are interior: bit k of `interior` for the edge from vertex k
// to the next. Nothing is to catch on these. `scratch` has three elements for each triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `scratch` has three elements for each triangle, and `interior` one.
septum_answer septum_tree32_interior_edges_f32(const septum_tree32_f32 *tree, uint32_t (*scratch)[2], uint8_t *interior);

// The contacts of a sphere with all triangles that it penetrates, in the tree's order, and the
// numbers of these: as many as `count` says, which then says how many there are. Each translation
// moves the triangle; the sphere moves by its opposite. `interior` may be null.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `interior` is null, or has an element for each triangle; `triangles` and `contacts` have `count`
// elements.
septum_answer septum_tree32_sphere_contacts_f32(const septum_tree32_f32 *tree, const septum_sphere_f32 *sphere, const uint8_t *interior, size_t *triangles, septum_contact_f32 *contacts, size_t *count);

// The same of a capsule.
//
// # Safety
// As for `septum_tree32_sphere_contacts_f32`.
septum_answer septum_tree32_capsule_contacts_f32(const septum_tree32_f32 *tree, const septum_capsule_f32 *capsule, const uint8_t *interior, size_t *triangles, septum_contact_f32 *contacts, size_t *count);

// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
// yes.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used.
septum_answer septum_tree32_open_f64(const septum_mesh32_f64 *mesh, septum_tree32_f64 *tree);

// Builds a tree over a mesh, whose own nodes are not looked at, in the memory of `nodes`, as many
// as [`septum_node_count`] says, and of `order`, an index for each triangle: yes, or the error. All
// three stay where they are for as long as the tree is used. Triangles keep their numbers.
//
// # Safety
// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
// used. `nodes` has `node_count` elements, and `order` one for each triangle.
septum_answer septum_tree32_build_f64(const septum_mesh32_f64 *mesh, uint16_t (*nodes)[6][4], size_t node_count, uint32_t *order, septum_tree32_f64 *tree);

// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree32_contains_f64(const septum_tree32_f64 *tree, const double *point);

// The first triangle that a ray hits, and the hit: written only if the answer is yes. Exact, as for
// a single triangle; of several at one point the least triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree32_first_hit_f64(const septum_tree32_f64 *tree, const septum_ray_f64 *ray, size_t *triangle, septum_hit_f64 *hit);

// Whether a ray hits any triangle, exactly.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree32_is_hit_f64(const septum_tree32_f64 *tree, const septum_ray_f64 *ray);

// Whether a box overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree32_aabb_f64(const septum_tree32_f64 *tree, const septum_aabb_f64 *aabb, size_t *triangle);

// Whether a sphere overlaps any triangle, exactly; the first in the tree's order is written if the
// answer is yes.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
septum_answer septum_tree32_sphere_f64(const septum_tree32_f64 *tree, const septum_sphere_f64 *sphere, size_t *triangle);

// The triangle closest to a point, exactly, and its point, rounded; of several at one distance the
// least triangle. No if the mesh is empty.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `point` leads to three numbers.
septum_answer septum_tree32_closest_point_f64(const septum_tree32_f64 *tree, const double *point, size_t *triangle, septum_closest_f64 *closest);

// The first triangle that a box meets as it moves by `motion`, and when: written only if the answer
// is yes. The verdict is exact, and the time is never late.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree32_aabb_cast_f64(const septum_tree32_f64 *tree, const septum_aabb_f64 *aabb, const double *motion, size_t *triangle, septum_first_contact_f64 *first);

// The same of a sphere.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `motion` leads to three numbers.
septum_answer septum_tree32_sphere_cast_f64(const septum_tree32_f64 *tree, const septum_sphere_f64 *sphere, const double *motion, size_t *triangle, septum_sphere_contact_f64 *first);

// Writes which edges of each triangle are interior: bit k of `interior` for the edge from vertex k
// to the next. Nothing is to catch on these. `scratch` has three elements for each triangle.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `scratch` has three elements for each triangle, and `interior` one.
septum_answer septum_tree32_interior_edges_f64(const septum_tree32_f64 *tree, uint32_t (*scratch)[2], uint8_t *interior);

// The contacts of a sphere with all triangles that it penetrates, in the tree's order, and the
// numbers of these: as many as `count` says, which then says how many there are. Each translation
// moves the triangle; the sphere moves by its opposite. `interior` may be null.
//
// # Safety
// The tree is zero, or was written by a function of this type, and its mesh has not moved.
// `interior` is null, or has an element for each triangle; `triangles` and `contacts` have `count`
// elements.
septum_answer septum_tree32_sphere_contacts_f64(const septum_tree32_f64 *tree, const septum_sphere_f64 *sphere, const uint8_t *interior, size_t *triangles, septum_contact_f64 *contacts, size_t *count);

// The same of a capsule.
//
// # Safety
// As for `septum_tree32_sphere_contacts_f64`.
septum_answer septum_tree32_capsule_contacts_f64(const septum_tree32_f64 *tree, const septum_capsule_f64 *capsule, const uint8_t *interior, size_t *triangles, septum_contact_f64 *contacts, size_t *count);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SEPTUM_H */
