// The C++ header asks the functions of septum.h: for each type of number, the verdict, what is
// written, and an error. Prints the number of its checks.

#include <cmath>
#include <cstdio>
#include <cstring>
#include <septum.hpp>

static int checks, failures;

static void check(bool holds, const char *what, const char *type) {
    checks++;
    if (!holds) {
        failures++;
        std::printf("%s, %s\n", what, type);
    }
}

// `one` is 1 in this type.
template <class S> static void pairs(S one, const char *type) {
    using t = septum::types<S>;
    const S o = 0, two = S(2 * one), four = S(4 * one);
    const typename t::triangle triangle = {{o, two, o}, {two, o, o}, {o, o, two}};
    const typename t::aabb cell = {{o, o, o}, {one, one, one}}, far = {{two, two, two}, {four, four, four}};
    const typename t::obb box = {{o, o, o}, {{one, o, o}, {o, one, o}, {o, o, one}}, {one, one, one}};
    const auto ray = septum::ray<S>({o, o, o}, {one, one, one}), away = septum::ray<S>({o, o, o}, {S(-one), o, o});
    check(bool(septum::overlaps(triangle, cell)), "overlaps cell", type);
    check(!septum::overlaps(triangle, far), "overlaps no far box", type);
    check(bool(septum::overlaps(triangle, box)), "overlaps oriented box", type);
    check(bool(septum::overlaps(triangle, triangle)), "overlaps itself", type);
    check(bool(septum::overlaps(ray, cell)), "ray meets cell", type);
    const typename t::sphere ball = {{o, o, o}, two}, small = {{o, o, o}, one}, inverted = {{o, o, o}, S(-one)};
    const typename t::capsule capsule = {{o, o, o}, {one, o, o}, one};
    check(bool(septum::overlaps(ball, triangle)) && !septum::overlaps(small, triangle), "ball", type);
    check(bool(septum::overlaps(ball, cell)) && !septum::overlaps(small, far), "ball and box", type);
    check(septum::contact(ball, triangle) && !septum::contact(small, far), "contact of a ball", type);
    const auto out = septum::contact(small, cell);
    check(out && out->depth == one && out->point_count == 1, "ball out of a box", type);
    check(septum::contact(capsule, triangle) && septum::contact(capsule, cell), "contact of a capsule", type);
    const auto range = septum::range(ray, ball);
    check(range && range->enter == o && range->leave > one, "range", type);
    check(bool(septum::overlaps(capsule, triangle)) && bool(septum::overlaps(capsule, cell)), "capsule", type);
    check(septum::overlaps(inverted, cell).answer() == SEPTUM_ANSWER_NEGATIVE_RADIUS, "no ball", type);
    const auto closest = septum::closest_point(triangle, {four, o, o});
    check(closest && closest->point[0] == two && closest->feature == 5, "closest", type);
    check(bool(septum::is_hit(ray, triangle)) && !septum::is_hit(away, triangle), "is hit", type);
    const auto hit = septum::hit(ray, triangle);
    check(hit && std::fabs(double(hit->t) / double(one) - 2.0 / 3.0) < 0.01, "t", type);
    const auto first = septum::cast(far, {S(-two), S(-two), S(-two)}, triangle);
    check(first && !septum::cast(far, {two, two, two}, triangle), "cast", type);
    const typename t::sphere thrown = {{S(-two), o, o}, one};
    const auto touched = septum::cast(thrown, {two, o, o}, cell);
    check(touched && touched->t == S(one / 2) && touched->part == 0, "cast of a ball", type);
    check(!septum::cast(thrown, {S(-two), o, o}, triangle), "cast of a ball away", type);
    check(bool(septum::contact(triangle, cell)), "contact", type);
    const auto contact = septum::contact(box, box);
    check(contact && contact->point_count > 0 && contact->depth == two, "contact of boxes", type);
    const auto turned = septum::turned(box, std::array<S, 4>{o, o, one, o});
    check(turned && turned->axes[0][0] == S(-one), "turned", type);
    check(septum::turned(box, std::array<S, 4>{o, o, o, o}).is_error(), "no quaternion", type);
    const auto none = septum::overlaps(triangle, typename t::aabb{{one, o, o}, {o, one, one}});
    check(none.answer() == SEPTUM_ANSWER_MIN_ABOVE_MAX && std::strlen(none.text()) > 0, "error", type);
}

template <class S> static void meshes(S one, const char *type) {
    using mesh = septum::mesh<S>;
    const S o = 0, h = S(one / 4);
    std::vector<septum::point<S>> corners = {{o, o, o}, {one, o, o}, {o, one, o}, {o, o, one}};
    const std::vector<typename mesh::triangle> faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    auto built = mesh::build(corners, faces);
    check(bool(built), "built", type);
    // Moved, it is the same mesh, and the other is empty.
    mesh assigned;
    assigned = *std::move(built);
    check(built->contains({o, o, o}).answer() == SEPTUM_ANSWER_NOT_OPEN, "moved from", type);
    check(built->triangles().empty(), "triangles moved", type);
    const mesh solid = std::move(assigned);
    check(assigned.contains({o, o, o}).answer() == SEPTUM_ANSWER_NOT_OPEN, "moved again", type);
    check(bool(solid.contains({h, h, h})) && !solid.contains({one, one, one}), "contains", type);
    const auto ray = septum::ray<S>({h, h, S(-one)}, {o, o, one});
    const auto hit = solid.first_hit(ray);
    check(hit && hit->triangle == 0 && hit->hit.t == one && solid.is_hit(ray), "first hit", type);
    const auto overlapping = solid.overlaps({{S(-one), S(-one), S(-one)}, {S(-h), h, h}});
    check(!overlapping && !overlapping.is_error(), "overlaps no box", type);
    check(bool(solid.overlaps({{S(-one), S(-one), S(-one)}, {h, h, h}})), "overlaps a box", type);
    const auto met = solid.cast({{h, h, S(-2 * one)}, {h, h, S(-one)}}, {o, o, one});
    check(met && met->triangle == 0, "cast", type);
    const auto near = solid.closest_point({h, S(-one), h});
    check(near && near->triangle == 1 && near->closest.point[1] == o, "closest of a mesh", type);
    using sphere = typename septum::types<S>::sphere;
    check(bool(solid.overlaps(sphere{{o, S(-one), o}, one})), "overlaps a ball", type);
    check(!solid.overlaps(sphere{{o, S(-one), o}, h}), "overlaps no ball", type);
    const auto dropped = solid.cast(sphere{{h, h, S(-2 * one)}, h}, {o, o, S(2 * one)});
    check(dropped && dropped->triangle == 0 && dropped->first.part == 0, "cast of a ball at a mesh", type);
    auto floor = *mesh::build(corners, faces);
    check(bool(floor.find_interior_edges()), "interior edges", type);
    const auto sunk = floor.contacts(sphere{{h, h, S(-h)}, S(2 * h)});
    check(sunk && !sunk->empty() && sunk->front().contact.point_count == 1, "contacts of a ball", type);
    const typename septum::types<S>::capsule post = {{h, h, S(-one)}, {h, h, one}, h};
    check(floor.contacts(post) && !floor.contacts(sphere{{o, S(-2 * one), o}, h}), "contacts", type);
    const auto bad = mesh::build(corners, {{0, 1, 9}});
    check(bad.answer() == SEPTUM_ANSWER_NO_SUCH_VERTEX, "no such vertex", type);
    check(mesh().contains({o, o, o}).answer() == SEPTUM_ANSWER_NOT_OPEN, "not built", type);
    const auto empty = mesh::build({}, {});
    check(empty && !empty->contains({o, o, o}) && !empty->is_hit(ray), "empty", type);
}

int main() {
    pairs<std::int16_t>(256, "I8F8"), meshes<std::int16_t>(256, "I8F8");
    pairs<std::int32_t>(65536, "I16F16"), meshes<std::int32_t>(65536, "I16F16");
    pairs<float>(1, "float"), meshes<float>(1, "float");
    pairs<double>(1, "double"), meshes<double>(1, "double");
    std::printf("C++: %d checks, %d fail\n", checks, failures);
    return failures != 0;
}
