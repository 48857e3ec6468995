// The functions of septum.h for C++17 and later: overloads for all types of number, and a mesh that
// owns its tree. Nothing throws but `std::vector` without memory. See bindings/c/README.md.
#ifndef SEPTUM_HPP
#define SEPTUM_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "septum.h"

namespace septum {

template <class S> using point = std::array<S, 3>;

// Yes, no, or an error. In a condition: whether it is yes.
class [[nodiscard]] verdict {
public:
    verdict(septum_answer answer) noexcept : answer_(answer) {}
    explicit operator bool() const noexcept { return answer_ == SEPTUM_ANSWER_YES; }
    bool is_error() const noexcept { return answer_ < 0; }
    septum_answer answer() const noexcept { return answer_; }
    // The answer in words, for a log.
    const char *text() const noexcept { return septum_text(answer_); }

private:
    septum_answer answer_;
};

// A verdict, and what was found if it is yes.
template <class T> class [[nodiscard]] found : public verdict {
public:
    found(septum_answer answer, T value = T()) : verdict(answer), value_(std::move(value)) {}
    const T &operator*() const & noexcept { return value_; }
    T &&operator*() && noexcept { return std::move(value_); }
    const T *operator->() const noexcept { return &value_; }

private:
    T value_;
};

// The structures of a type of number: `int16_t` is I8F8, and `int32_t` I16F16.
template <class S> struct types;

// The triangle of a mesh that a ray or a moving shape meets, that is closest to a point, or that a
// shape penetrates, and where.
template <class S> struct mesh_hit { std::size_t triangle; typename types<S>::hit hit; };
template <class S> struct mesh_contact { std::size_t triangle; typename types<S>::first_contact first; };
template <class S> struct mesh_sphere_contact { std::size_t triangle; typename types<S>::sphere_contact first; };
template <class S> struct mesh_manifold { std::size_t triangle; typename types<S>::contact contact; };
template <class S> struct mesh_closest { std::size_t triangle; typename types<S>::closest closest; };

#define SEPTUM_OVERLAP(N, A, B)                                                                    \
    inline verdict overlaps(const septum_##A##_##N &a, const septum_##B##_##N &b) noexcept {       \
        return septum_##A##_##B##_##N(&a, &b);                                                     \
    }

#define SEPTUM_FOUND(N, NAME, F, FOUND, A, B)                                                      \
    inline found<septum_##FOUND##_##N> NAME(const septum_##A##_##N &a, const septum_##B##_##N &b) {\
        septum_##FOUND##_##N value{};                                                              \
        return {septum_##F##_##N(&a, &b, &value), value};                                          \
    }

#define SEPTUM_CAST(S, N, A, FIRST, B)                                                             \
    inline found<septum_##FIRST##_##N> cast(                                                       \
        const septum_##A##_##N &a, const point<S> &motion, const septum_##B##_##N &b) {            \
        septum_##FIRST##_##N value{};                                                              \
        return {septum_##A##_cast_##B##_##N(&a, motion.data(), &b, &value), value};                \
    }

#define SEPTUM_PAIRS(S, N)                                                                         \
    SEPTUM_OVERLAP(N, triangle, aabb) SEPTUM_OVERLAP(N, triangle, obb)                             \
    SEPTUM_OVERLAP(N, triangle, triangle) SEPTUM_OVERLAP(N, ray, aabb)                             \
    SEPTUM_OVERLAP(N, sphere, triangle) SEPTUM_OVERLAP(N, sphere, aabb)                            \
    SEPTUM_OVERLAP(N, capsule, triangle) SEPTUM_OVERLAP(N, capsule, aabb)                          \
    SEPTUM_FOUND(N, hit, ray_triangle_hit, hit, ray, triangle)                                     \
    SEPTUM_FOUND(N, contact, triangle_aabb_contact, contact, triangle, aabb)                       \
    SEPTUM_FOUND(N, contact, obb_obb_contact, contact, obb, obb)                                   \
    SEPTUM_FOUND(N, contact, sphere_triangle_contact, contact, sphere, triangle)                   \
    SEPTUM_FOUND(N, contact, sphere_aabb_contact, contact, sphere, aabb)                           \
    SEPTUM_FOUND(N, contact, capsule_triangle_contact, contact, capsule, triangle)                 \
    SEPTUM_FOUND(N, contact, capsule_aabb_contact, contact, capsule, aabb)                         \
    SEPTUM_FOUND(N, range, ray_sphere_range, range, ray, sphere)                                   \
    SEPTUM_CAST(S, N, aabb, first_contact, triangle)                                               \
    SEPTUM_CAST(S, N, sphere, sphere_contact, triangle)                                            \
    SEPTUM_CAST(S, N, sphere, sphere_contact, aabb)                                                \
    inline verdict is_hit(const septum_ray_##N &a, const septum_triangle_##N &b) noexcept {        \
        return septum_ray_triangle_##N(&a, &b);                                                    \
    }                                                                                              \
    inline found<septum_closest_##N> closest_point(                                                \
        const septum_triangle_##N &a, const point<S> &p) {                                         \
        septum_closest_##N value{};                                                                \
        return {septum_triangle_closest_point_##N(&a, p.data(), &value), value};                   \
    }                                                                                              \
    /* A box that is turned by a unit quaternion x, y, z, w. */                                    \
    inline found<septum_obb_##N> turned(septum_obb_##N box, const std::array<S, 4> &by) {          \
        const septum_answer answer = septum_obb_turn_##N(&box, by.data());                         \
        return {answer, box};                                                                      \
    }

#define SEPTUM_TYPE(N, T) using T = septum_##T##_##N;
#define SEPTUM_ASK(N, TREE, F) static constexpr auto ask_##F = septum_##TREE##_##F##_##N;

// TREE is tree or tree32, MESH likewise.
#define SEPTUM_TYPES(S, N, INDEX, MESH, TREE)                                                      \
    SEPTUM_PAIRS(S, N)                                                                             \
    template <> struct types<S> {                                                                  \
        using index = INDEX;                                                                       \
        using mesh = septum_##MESH##_##N; using tree = septum_##TREE##_##N;                        \
        SEPTUM_TYPE(N, triangle) SEPTUM_TYPE(N, aabb) SEPTUM_TYPE(N, obb) SEPTUM_TYPE(N, sphere)   \
        SEPTUM_TYPE(N, capsule) SEPTUM_TYPE(N, ray) SEPTUM_TYPE(N, hit) SEPTUM_TYPE(N, closest)    \
        SEPTUM_TYPE(N, first_contact) SEPTUM_TYPE(N, sphere_contact) SEPTUM_TYPE(N, contact)       \
        SEPTUM_TYPE(N, range)                                                                      \
        SEPTUM_ASK(N, TREE, build) SEPTUM_ASK(N, TREE, contains) SEPTUM_ASK(N, TREE, first_hit)    \
        SEPTUM_ASK(N, TREE, is_hit) SEPTUM_ASK(N, TREE, aabb) SEPTUM_ASK(N, TREE, sphere)          \
        SEPTUM_ASK(N, TREE, aabb_cast) SEPTUM_ASK(N, TREE, closest_point)                          \
        SEPTUM_ASK(N, TREE, sphere_cast) SEPTUM_ASK(N, TREE, interior_edges)                       \
        SEPTUM_ASK(N, TREE, sphere_contacts) SEPTUM_ASK(N, TREE, capsule_contacts)                 \
    };

SEPTUM_TYPES(std::int16_t, i8f8, std::uint16_t, mesh, tree)
SEPTUM_TYPES(std::int32_t, i16f16, std::uint16_t, mesh, tree)
SEPTUM_TYPES(float, f32, std::uint32_t, mesh32, tree32)
SEPTUM_TYPES(double, f64, std::uint32_t, mesh32, tree32)
#undef SEPTUM_TYPES
#undef SEPTUM_PAIRS
#undef SEPTUM_OVERLAP
#undef SEPTUM_FOUND
#undef SEPTUM_CAST
#undef SEPTUM_TYPE
#undef SEPTUM_ASK

// From the origin on, without an end.
template <class S>
typename types<S>::ray ray(const point<S> &origin, const point<S> &direction) noexcept {
    using limits = std::numeric_limits<S>;
    return {{origin[0], origin[1], origin[2]},
            {direction[0], direction[1], direction[2]},
            S(0),
            limits::has_infinity ? limits::infinity() : limits::max()};
}

// A mesh and its tree. It can be moved, not copied. As `mesh` only `build` makes it, unless it is
// empty, and has no tree to ask.
template <class S> class mesh {
    using t = types<S>;

public:
    using index = typename t::index;
    using triangle = std::array<index, 3>;

    mesh() = default;
    // What was moved from is empty: its tree would point to memory of the other.
    mesh(mesh &&other) noexcept
        : vertices_(std::move(other.vertices_)), triangles_(std::move(other.triangles_)),
          nodes_(std::move(other.nodes_)), order_(std::move(other.order_)),
          interior_(std::move(other.interior_)), tree_(std::exchange(other.tree_, {})) {}
    mesh &operator=(mesh &&other) noexcept {
        mesh moved(std::move(other));
        vertices_.swap(moved.vertices_);
        triangles_.swap(moved.triangles_);
        nodes_.swap(moved.nodes_);
        order_.swap(moved.order_);
        interior_.swap(moved.interior_);
        std::swap(tree_, moved.tree_);
        return *this;
    }

    // The error, if it is one, says what is wrong with the mesh.
    static found<mesh> build(std::vector<point<S>> vertices, std::vector<triangle> triangles) {
        mesh made;
        made.vertices_ = std::move(vertices);
        made.triangles_ = std::move(triangles);
        made.nodes_.resize(septum_node_count(made.triangles_.size()) + 1);
        made.order_.resize(made.triangles_.size() + 1);
        // Without an element a vector may have a null pointer.
        made.vertices_.reserve(1);
        made.triangles_.reserve(1);
        const typename t::mesh tables = {
            reinterpret_cast<const S(*)[3]>(made.vertices_.data()), made.vertices_.size(),
            reinterpret_cast<const index(*)[3]>(made.triangles_.data()), made.triangles_.size(),
            nullptr, 0};
        const septum_answer answer =
            t::ask_build(&tables, reinterpret_cast<std::uint16_t(*)[6][4]>(made.nodes_.data()),
                     made.nodes_.size() - 1, made.order_.data(), &made.tree_);
        return {answer, std::move(made)};
    }

    verdict contains(const point<S> &p) const noexcept { return t::ask_contains(&tree_, p.data()); }
    verdict is_hit(const typename t::ray &ray) const noexcept { return t::ask_is_hit(&tree_, &ray); }
    found<mesh_hit<S>> first_hit(const typename t::ray &ray) const {
        mesh_hit<S> value{};
        return {t::ask_first_hit(&tree_, &ray, &value.triangle, &value.hit), value};
    }
    // Whether a box or a ball overlaps any triangle, and the first in the tree's order.
    found<std::size_t> overlaps(const typename t::aabb &box) const {
        std::size_t value{};
        return {t::ask_aabb(&tree_, &box, &value), value};
    }
    found<std::size_t> overlaps(const typename t::sphere &ball) const {
        std::size_t value{};
        return {t::ask_sphere(&tree_, &ball, &value), value};
    }
    found<mesh_closest<S>> closest_point(const point<S> &p) const {
        mesh_closest<S> value{};
        return {t::ask_closest_point(&tree_, p.data(), &value.triangle, &value.closest), value};
    }
    found<mesh_contact<S>> cast(const typename t::aabb &box, const point<S> &motion) const {
        mesh_contact<S> value{};
        return {t::ask_aabb_cast(&tree_, &box, motion.data(), &value.triangle, &value.first), value};
    }
    found<mesh_sphere_contact<S>> cast(const typename t::sphere &ball, const point<S> &motion) const {
        mesh_sphere_contact<S> value{};
        return {t::ask_sphere_cast(&tree_, &ball, motion.data(), &value.triangle, &value.first), value};
    }
    // Finds the interior edges, on which nothing is to catch: once, before `contacts`.
    verdict find_interior_edges() {
        std::vector<std::array<index, 2>> scratch(3 * triangles_.size() + 1);
        interior_.resize(triangles_.size() + 1);
        return t::ask_interior_edges(
            &tree_, reinterpret_cast<index(*)[2]>(scratch.data()), interior_.data());
    }
    // The contacts with all triangles that a ball or a capsule penetrates. Each translation moves
    // the triangle; the shape moves by its opposite.
    found<std::vector<mesh_manifold<S>>> contacts(const typename t::sphere &ball) const {
        return all_contacts(t::ask_sphere_contacts, ball);
    }
    found<std::vector<mesh_manifold<S>>> contacts(const typename t::capsule &capsule) const {
        return all_contacts(t::ask_capsule_contacts, capsule);
    }
    const std::vector<point<S>> &vertices() const noexcept { return vertices_; }
    const std::vector<triangle> &triangles() const noexcept { return triangles_; }

private:
    template <class F, class A>
    found<std::vector<mesh_manifold<S>>> all_contacts(F ask, const A &shape) const {
        std::vector<std::size_t> which;
        std::vector<typename t::contact> contacts;
        const std::uint8_t *const interior = interior_.empty() ? nullptr : interior_.data();
        for (std::size_t room = 8;; room = which.size()) {
            which.resize(room);
            contacts.resize(room);
            const septum_answer answer =
                ask(&tree_, &shape, interior, which.data(), contacts.data(), &room);
            if (answer == SEPTUM_ANSWER_YES && room > which.size()) {
                which.resize(room);
                continue;
            }
            std::vector<mesh_manifold<S>> value;
            for (std::size_t i = 0; answer == SEPTUM_ANSWER_YES && i < room; i++) {
                value.push_back({which[i], contacts[i]});
            }
            return {answer, std::move(value)};
        }
    }

    std::vector<point<S>> vertices_;
    std::vector<triangle> triangles_;
    std::vector<std::array<std::array<std::uint16_t, 4>, 6>> nodes_;
    std::vector<index> order_;
    std::vector<std::uint8_t> interior_;
    // Of zeros it is not open, and says so.
    typename t::tree tree_{};
};

} // namespace septum

#endif // SEPTUM_HPP
