// tinybvh's tree of eight boxes a node, for AVX2.

#define TINYBVH_IMPLEMENTATION
#include <tiny_bvh.h>

#include <vector>

using tinybvh::Ray;

struct Tree {
    std::vector<tinybvh::bvhvec4> corners;
    tinybvh::BVH8_CPU bvh;
};

// Triangles of nine numbers each; the slowest and best build.
extern "C" Tree *tinybvh_new(const float *n, size_t count) {
    Tree *tree = new Tree;
    for (size_t i = 0; i < 9 * count; i += 3) {
        tree->corners.emplace_back(n[i], n[i + 1], n[i + 2], 0.0f);
    }
    tree->bvh.BuildHQ(tree->corners.data(), static_cast<uint32_t>(count));
    return tree;
}

extern "C" void tinybvh_free(Tree *tree) { delete tree; }

// From an origin along a direction, with reciprocals.
extern "C" Ray *tinybvh_ray_new(const float *n) {
    return new Ray({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
}

extern "C" void tinybvh_ray_free(Ray *ray) { delete ray; }

extern "C" bool tinybvh_first_hit(const Tree *tree, const Ray *prepared) {
    Ray ray = *prepared;
    tree->bvh.Intersect(ray);
    return ray.hit.t < prepared->hit.t;
}

extern "C" bool tinybvh_any_hit(const Tree *tree, const Ray *ray) {
    return tree->bvh.IsOccluded(*ray);
}
