// As pick.c, in C++: ./pick-cpp mesh.obj

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <septum.hpp>
#include <sstream>
#include <string>

using mesh = septum::mesh<float>;

[[noreturn]] static void refuse(const char *path, unsigned line, const char *why) {
    std::fprintf(stderr, "%s: line %u: %s\n", path, line, why);
    std::exit(1);
}

// Polygons become fans of triangles; a corner's texture and normal are passed over.
static septum::found<mesh> load(const char *path) {
    std::vector<septum::point<float>> vertices;
    std::vector<mesh::triangle> triangles;
    std::ifstream file(path);
    if (!file) {
        std::perror(path);
        std::exit(1);
    }
    unsigned number = 0;
    for (std::string line, word; std::getline(file, line);) {
        number++;
        std::istringstream words(line.substr(0, line.find('#')));
        word.clear();
        words >> word;
        if (word == "v") {
            septum::point<float> p;
            if (!(words >> p[0] >> p[1] >> p[2])) {
                refuse(path, number, "not three numbers");
            }
            vertices.push_back(p);
        } else if (word == "f") {
            std::vector<mesh::index> corners;
            while (words >> word) {
                char *end;
                const long long corner = std::strtoll(word.c_str(), &end, 10);
                if (end == word.c_str() || (*end != '/' && *end != '\0') || corner < 1 || corner > 0xffffffff) {
                    refuse(path, number, "a corner that is no number of a vertex, counted from 1");
                }
                corners.push_back(mesh::index(corner - 1));
            }
            if (corners.size() < 3) {
                refuse(path, number, "fewer than three corners");
            }
            for (std::size_t k = 2; k < corners.size(); k++) {
                triangles.push_back({corners[0], corners[k - 1], corners[k]});
            }
        }
    }
    if (triangles.empty()) {
        std::fprintf(stderr, "%s: no faces\n", path);
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
