/* As pick.c on a board, with mesh and tree in flash: table.h is what ./pick mesh.obj table.h wrote. C
   and C++. */

#include "../board.h"
#include "table.h"
#include <septum.h>

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

/* A positive number as printf's %a has it. */
static void print_exactly(float x) {
    union {
        float number;
        uint32_t bits;
    } both = {x};
    char text[] = "0x1.000000";
    size_t length = sizeof text - 1;
    for (int k = 0; k < 6; k++) {
        text[4 + k] = "0123456789abcdef"[(both.bits << 1) >> (20 - 4 * k) & 15];
    }
    while (text[length - 1] == '0') {
        length--;
    }
    text[text[length - 1] == '.' ? length - 1 : length] = 0;
    int exponent = (int)(both.bits >> 23) - 127;
    print(text);
    print_number(exponent < 0 ? "p-" : "p+", (uint32_t)(exponent < 0 ? -exponent : exponent), 10);
}

int main(void) {
    septum_mesh_f32 mesh = {vertices, COUNT(vertices), triangles, COUNT(triangles), nodes, COUNT(nodes)};
    septum_tree_f32 tree;
    septum_answer opened = septum_tree_open_f32(&mesh, &tree);
    if (opened != SEPTUM_ANSWER_YES) {
        print(septum_text(opened));
        return 1;
    }
    septum_ray_f32 ray = {{0.5f, 20.0f, 0.25f}, {0.0f, -1.0f, 0.0f}, 0.0f, 100.0f};
    septum_hit_f32 hit;
    size_t triangle;
    septum_answer picked = septum_tree_first_hit_f32(&tree, &ray, &triangle, &hit);
    if (picked == SEPTUM_ANSWER_YES) {
        print_number("", COUNT(triangles), 10);
        print_number(" triangles; triangle ", order[triangle], 10);
        print(" at t = ");
        print_exactly(hit.t);
        print("\n");
    }
    unsigned inside = 0;
    for (int k = 0; k < 1000; k++) {
        const float point[3] = {(float)(k % 10) - 5.0f, (float)(k / 10 % 10), (float)(k / 100) - 5.0f};
        inside += septum_tree_contains_f32(&tree, point) == SEPTUM_ANSWER_YES;
    }
    print_number("", inside, 10);
    print(" of 1000 points inside; septum " SEPTUM_VERSION_TEXT "\n");
    return picked != SEPTUM_ANSWER_YES;
}
