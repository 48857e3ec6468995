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

// The triangle of a mesh that a ray or a moving box meets, and where or when.
template <class S> struct mesh_hit {
    std::size_t triangle;
    typename types<S>::hit hit;
};
template <class S> struct mesh_contact {
    std::size_t triangle;
    typename types<S>::first_contact first;
};

#define SEPTUM_PAIRS(S, N)                                                                         \
    inline verdict overlaps(const septum_triangle_##N &a, const septum_aabb_##N &b) noexcept {     \
        return septum_triangle_aabb_##N(&a, &b);                                                   \
    }                                                                                              \
    inline verdict overlaps(const septum_triangle_##N &a, const septum_obb_##N &b) noexcept {      \
        return septum_triangle_obb_##N(&a, &b);                                                    \
    }                                                                                              \
    inline verdict overlaps(const septum_triangle_##N &a, const septum_triangle_##N &b) noexcept { \
        return septum_triangle_triangle_##N(&a, &b);                                               \
    }                                                                                              \
    inline verdict overlaps(const septum_ray_##N &a, const septum_aabb_##N &b) noexcept {          \
        return septum_ray_aabb_##N(&a, &b);                                                        \
    }                                                                                              \
    inline verdict is_hit(const septum_ray_##N &a, const septum_triangle_##N &b) noexcept {        \
        return septum_ray_triangle_##N(&a, &b);                                                    \
    }                                                                                              \
    inline found<septum_hit_##N> hit(const septum_ray_##N &a, const septum_triangle_##N &b) {      \
        septum_hit_##N value{};                                                                    \
        return {septum_ray_triangle_hit_##N(&a, &b, &value), value};                               \
    }                                                                                              \
    inline found<septum_first_contact_##N> cast(                                                   \
        const septum_aabb_##N &a, const point<S> &motion, const septum_triangle_##N &b) {          \
        septum_first_contact_##N value{};                                                          \
        return {septum_aabb_cast_triangle_##N(&a, motion.data(), &b, &value), value};              \
    }                                                                                              \
    inline found<septum_contact_##N> contact(                                                      \
        const septum_triangle_##N &a, const septum_aabb_##N &b) {                                  \
        septum_contact_##N value{};                                                                \
        return {septum_triangle_aabb_contact_##N(&a, &b, &value), value};                          \
    }                                                                                              \
    inline found<septum_contact_##N> contact(const septum_obb_##N &a, const septum_obb_##N &b) {   \
        septum_contact_##N value{};                                                                \
        return {septum_obb_obb_contact_##N(&a, &b, &value), value};                                \
    }                                                                                              \
    /* A box that is turned by a unit quaternion x, y, z, w. */                                    \
    inline found<septum_obb_##N> turned(septum_obb_##N box, const std::array<S, 4> &by) {          \
        const septum_answer answer = septum_obb_turn_##N(&box, by.data());                         \
        return {answer, box};                                                                      \
    }

// TREE is tree or tree32, MESH likewise.
#define SEPTUM_TYPES(S, N, INDEX, MESH, TREE)                                                      \
    SEPTUM_PAIRS(S, N)                                                                             \
    template <> struct types<S> {                                                                  \
        using index = INDEX;                                                                       \
        using triangle = septum_triangle_##N;                                                      \
        using aabb = septum_aabb_##N;                                                              \
        using obb = septum_obb_##N;                                                                \
        using ray = septum_ray_##N;                                                                \
        using hit = septum_hit_##N;                                                                \
        using first_contact = septum_first_contact_##N;                                            \
        using contact = septum_contact_##N;                                                        \
        using mesh = septum_##MESH##_##N;                                                          \
        using tree = septum_##TREE##_##N;                                                          \
        static constexpr auto build = septum_##TREE##_build_##N;                                   \
        static constexpr auto contains = septum_##TREE##_contains_##N;                             \
        static constexpr auto first_hit = septum_##TREE##_first_hit_##N;                           \
        static constexpr auto is_hit = septum_##TREE##_is_hit_##N;                                 \
        static constexpr auto aabb_overlap = septum_##TREE##_aabb_##N;                             \
        static constexpr auto aabb_cast = septum_##TREE##_aabb_cast_##N;                           \
    };

SEPTUM_TYPES(std::int16_t, i8f8, std::uint16_t, mesh, tree)
SEPTUM_TYPES(std::int32_t, i16f16, std::uint16_t, mesh, tree)
SEPTUM_TYPES(float, f32, std::uint32_t, mesh32, tree32)
SEPTUM_TYPES(double, f64, std::uint32_t, mesh32, tree32)
#undef SEPTUM_TYPES
#undef SEPTUM_PAIRS

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
    mesh(mesh &&) = default;
    mesh &operator=(mesh &&) = default;

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
            t::build(&tables, reinterpret_cast<std::uint16_t(*)[6][4]>(made.nodes_.data()),
                     made.nodes_.size() - 1, made.order_.data(), &made.tree_);
        return {answer, std::move(made)};
    }

    verdict contains(const point<S> &p) const noexcept { return t::contains(&tree_, p.data()); }
    verdict is_hit(const typename t::ray &ray) const noexcept { return t::is_hit(&tree_, &ray); }
    found<mesh_hit<S>> first_hit(const typename t::ray &ray) const {
        mesh_hit<S> value{};
        return {t::first_hit(&tree_, &ray, &value.triangle, &value.hit), value};
    }
    // Whether a box overlaps any triangle, and the first in the tree's order.
    found<std::size_t> overlaps(const typename t::aabb &box) const {
        std::size_t value{};
        return {t::aabb_overlap(&tree_, &box, &value), value};
    }
    found<mesh_contact<S>> cast(const typename t::aabb &box, const point<S> &motion) const {
        mesh_contact<S> value{};
        return {t::aabb_cast(&tree_, &box, motion.data(), &value.triangle, &value.first), value};
    }
    const std::vector<point<S>> &vertices() const noexcept { return vertices_; }
    const std::vector<triangle> &triangles() const noexcept { return triangles_; }

private:
    std::vector<point<S>> vertices_;
    std::vector<triangle> triangles_;
    std::vector<std::array<std::array<std::uint16_t, 4>, 6>> nodes_;
    std::vector<index> order_;
    // Of zeros it is not open, and says so.
    typename t::tree tree_{};
};

} // namespace septum

#endif // SEPTUM_HPP
