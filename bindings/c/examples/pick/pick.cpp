// As pick.c, in C++: ./pick-cpp mesh.obj

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <septum.hpp>
#include <sstream>
#include <string>

using mesh = septum::mesh<float>;

static septum::found<mesh> load(const char *path) {
    std::vector<septum::point<float>> vertices;
    std::vector<mesh::triangle> triangles;
    std::ifstream file(path);
    if (!file) {
        std::perror(path);
        std::exit(1);
    }
    for (std::string line, word; std::getline(file, line);) {
        std::istringstream words(line);
        words >> word;
        if (septum::point<float> p; word == "v" && words >> p[0] >> p[1] >> p[2]) {
            vertices.push_back(p);
        } else if (mesh::triangle t; word == "f" && words >> t[0] >> t[1] >> t[2]) {
            triangles.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
        }
    }
    if (triangles.empty()) {
        std::fprintf(stderr, "%s: no lines \"f\" with three vertices\n", path);
        std::exit(1);
    }
    return mesh::build(std::move(vertices), std::move(triangles));
}

int main(int count, char **arguments) {
    if (count < 2) {
        std::fprintf(stderr, "usage: pick-cpp mesh.obj\n");
        return 1;
    }
    const auto loaded = load(arguments[1]);
    if (!loaded) {
        std::fprintf(stderr, "%s\n", loaded.text());
        return 1;
    }
    auto ray = septum::ray<float>({0.5f, 20.0f, 0.25f}, {0.0f, -1.0f, 0.0f});
    ray.t_max = 100.0f;
    const auto picked = loaded->first_hit(ray);
    if (picked) {
        std::printf("%zu triangles; triangle %zu at t = %a\n", loaded->triangles().size(),
                    picked->triangle, static_cast<double>(picked->hit.t));
    }
    unsigned inside = 0;
    for (int k = 0; k < 1000; k++) {
        inside += bool(loaded->contains({float(k % 10) - 5.0f, float(k / 10 % 10), float(k / 100) - 5.0f}));
    }
    std::printf("%u of 1000 points inside; septum %s\n", inside, SEPTUM_VERSION_TEXT);
    return picked ? 0 : 1;
}
