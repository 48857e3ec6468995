/* Loads an OBJ, builds a tree in its own memory, picks along an axis and asks what is inside. C and
   C++: ./pick mesh.obj. With ./pick mesh.obj table.h it also writes both for flash: see flash.c. */

#include <septum.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST 65536

static float vertices[MOST][3];
static uint16_t triangles[MOST][3], order[MOST];
static uint16_t nodes[MOST / 4][6][4];

static void refuse(const char *path, unsigned line, const char *why) {
    fprintf(stderr, "%s: line %u: %s\n", path, line, why);
    exit(1);
}

/* Polygons become fans of triangles; a corner's texture and normal are passed over. */
static size_t load(const char *path, size_t *vertex_count) {
    FILE *file = fopen(path, "r");
    char text[1024];
    size_t v = 0, t = 0;
    if (file == NULL) {
        perror(path);
        exit(1);
    }
    for (unsigned line = 1; fgets(text, sizeof text, file) != NULL; line++) {
        if (strchr(text, '\n') == NULL && !feof(file)) {
            refuse(path, line, "too long");
        }
        text[strcspn(text, "#\r\n")] = '\0';
        const char *name = strtok(text, " \t");
        if (name == NULL) {
            continue;
        }
        if (strcmp(name, "v") == 0) {
            if (v == MOST) {
                refuse(path, line, "more than 65536 vertices");
            }
            const char *numbers = strtok(NULL, "");
            float *p = vertices[v++];
            if (numbers == NULL || sscanf(numbers, "%f %f %f", &p[0], &p[1], &p[2]) != 3) {
                refuse(path, line, "not three numbers");
            }
        } else if (strcmp(name, "f") == 0) {
            uint16_t corners[3] = {0, 0, 0};
            unsigned count = 0;
            for (const char *word; (word = strtok(NULL, " \t")) != NULL;) {
                char *end;
                const long number = strtol(word, &end, 10);
                if (end == word || (*end != '/' && *end != '\0') || number < 1 || number > MOST) {
                    refuse(path, line, "a corner that is no number from 1 to 65536");
                }
                corners[count < 2 ? count : 2] = (uint16_t)(number - 1);
                count++;
                if (count < 3) {
                    continue;
                }
                if (t == MOST) {
                    refuse(path, line, "more than 65536 triangles");
                }
                memcpy(triangles[t++], corners, sizeof corners);
                corners[1] = corners[2];
            }
            if (count < 3) {
                refuse(path, line, "fewer than three corners");
            }
        }
    }
    fclose(file);
    *vertex_count = v;
    return t;
}

/* For flash: triangles are in the tree's order there, and `order` has their numbers in the file. */
static int write_table(const char *path, size_t vertex_count, size_t triangle_count) {
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        return 0;
    }
    fputs("static const float vertices[][3] = {\n", file);
    for (size_t i = 0; i < vertex_count; i++) {
        const float *p = vertices[i];
        fprintf(file, "    {%af, %af, %af},\n", (double)p[0], (double)p[1], (double)p[2]);
    }
    fputs("};\nstatic const uint16_t triangles[][3] = {\n", file);
    for (size_t i = 0; i < triangle_count; i++) {
        const uint16_t *t = triangles[order[i]];
        fprintf(file, "    {%u, %u, %u},\n", t[0], t[1], t[2]);
    }
    fputs("};\nstatic const uint16_t order[] = {\n", file);
    for (size_t i = 0; i < triangle_count; i++) {
        fprintf(file, "    %u,\n", order[i]);
    }
    fputs("};\nstatic const uint16_t nodes[][6][4] = {\n", file);
    for (size_t i = 0; i < septum_node_count(triangle_count); i++) {
        fputs("    {", file);
        for (int k = 0; k < 6; k++) {
            const uint16_t *n = nodes[i][k];
            fprintf(file, "{%u, %u, %u, %u}, ", n[0], n[1], n[2], n[3]);
        }
        fputs("},\n", file);
    }
    fputs("};\n", file);
    return fclose(file) == 0;
}

int main(int count, char **arguments) {
    if (count < 2) {
        fprintf(stderr, "usage: pick mesh.obj [table.h]\n");
        return 1;
    }
    size_t vertex_count = 0, triangle_count = load(arguments[1], &vertex_count);
    if (triangle_count == 0) {
        fprintf(stderr, "%s: no faces\n", arguments[1]);
        return 1;
    }
    septum_mesh_f32 mesh = {vertices, vertex_count, triangles, triangle_count, NULL, 0};
    septum_tree_f32 tree;
    septum_answer built = septum_tree_build_f32(&mesh, nodes, septum_node_count(triangle_count), order, &tree);
    if (built != SEPTUM_ANSWER_YES) {
        fprintf(stderr, "%s\n", septum_text(built));
        return 1;
    }
    if (count > 2 && !write_table(arguments[2], vertex_count, triangle_count)) {
        perror(arguments[2]);
        return 1;
    }
    septum_ray_f32 ray = {{0.5f, 20.0f, 0.25f}, {0.0f, -1.0f, 0.0f}, 0.0f, 100.0f};
    septum_hit_f32 hit;
    size_t triangle;
    septum_answer picked = septum_tree_first_hit_f32(&tree, &ray, &triangle, &hit);
    if (picked == SEPTUM_ANSWER_YES) {
        printf("%zu triangles; triangle %zu at t = %a\n", triangle_count, triangle, (double)hit.t);
    }
    unsigned inside = 0;
    for (int k = 0; k < 1000; k++) {
        const float point[3] = {(float)(k % 10) - 5.0f, (float)(k / 10 % 10), (float)(k / 100) - 5.0f};
        inside += septum_tree_contains_f32(&tree, point) == SEPTUM_ANSWER_YES;
    }
    printf("%u of 1000 points inside; septum %s\n", inside, SEPTUM_VERSION_TEXT);
    return picked != SEPTUM_ANSWER_YES;
}
