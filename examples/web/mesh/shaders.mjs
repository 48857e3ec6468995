// The programs of the graphics card.
import { ACROSS, WAYS } from './faces.mjs';

const list = (vectors) => vectors.map((v) => `ivec3(${v.map(Math.round)})`).join();
const unit = (i) => [0, 1, 2].map((k) => (k === i ? 1 : 0));

/** The colours of the surface from foot to top, as those of the example `voxelize`. */
const GLAZE = [[38, 70, 120], [38, 128, 150], [96, 176, 140], [236, 190, 108], [232, 112, 84]];
const glaze = GLAZE.map((color) => `vec3(${color.map((x) => (x / 255).toFixed(3))})`).join();

const LIGHT = `
uniform vec3 right, up, away;
/** From above, from the left, and a little from everywhere. */
float light(vec3 normal) {
    vec3 from = normalize(up * 0.9 - right * 0.45 - away * 0.6);
    return 0.62 + 0.4 * max(dot(normal, from), 0.0) + 0.06 * dot(normal, up);
}
vec3 glaze(float height) {
    vec3 stops[${GLAZE.length}] = vec3[](${glaze});
    float at = clamp(height, 0.0, 1.0) * ${(GLAZE.length - 1).toFixed(1)};
    int i = min(int(at), ${GLAZE.length - 2});
    return mix(stops[i], stops[i + 1], at - float(i));
}`;

/** A face for each six vertices, two triangles. Instances of four vertices are slow, most of all without a graphics card. */
export const VOXELS = {
    vertex: `#version 300 es
precision highp float;
uniform mat4 matrix;
uniform float rise;
uniform vec4 paint;
uniform vec3 height;
uniform float heights;
uniform highp usampler2D faces;
out vec3 color;
out vec2 place;
${LIGHT}
void main() {
    ivec3 ways[6] = ivec3[](${list(WAYS)});
    ivec3 us[6] = ivec3[](${list(ACROSS.map(([u]) => unit(u)))});
    ivec3 vs[6] = ivec3[](${list(ACROSS.map(([, v]) => unit(v)))});
    int k = gl_VertexID / 6, wide = textureSize(faces, 0).x;
    uvec2 face = texelFetch(faces, ivec2(k % wide, k / wide), 0).xy;
    uint bits = face.x;
    ivec3 voxel = ivec3(int(bits & 255u), int(bits >> 8 & 255u), int(bits >> 16 & 255u));
    int way = int(bits >> 24);
    int corners[6] = int[](0, 1, 2, 2, 1, 3);
    int number = corners[gl_VertexID % 6];
    ivec2 corner = ivec2(number & 1, number >> 1);
    vec3 normal = vec3(ways[way]);
    vec3 at = vec3(voxel + max(ways[way], ivec3(0)) + us[way] * corner.x + vs[way] * corner.y);
    gl_Position = matrix * vec4(at + normal * rise, 1.0);
    float open = float(face.y >> uint(2 * number) & 3u) / 3.0;
    vec3 surface = mix(glaze((dot(vec3(voxel) + 0.5, height)) / heights), paint.rgb, paint.a);
    color = surface * light(normal) * (0.55 + 0.45 * open);
    place = vec2(corner);
}`,
    fragment: `#version 300 es
precision highp float;
in vec3 color;
in vec2 place;
out vec4 pixel;
void main() {
    // A line around a face, where faces are large enough for it.
    vec2 wide = fwidth(place);
    vec2 inner = min(place, 1.0 - place) / wide;
    float edge = 1.0 - smoothstep(0.4, 1.2, min(inner.x, inner.y));
    float seen = 1.0 - smoothstep(0.06, 0.22, max(wide.x, wide.y));
    pixel = vec4(color * (1.0 - 0.22 * edge * seen), 1.0);
}`,
};

/** Triangles as they are, both sides alike. */
export const TRIANGLES = {
    vertex: `#version 300 es
precision highp float;
uniform mat4 matrix;
uniform vec3 height;
uniform float heights;
in vec3 corner;
out vec3 at;
out float high;
out vec3 place;
void main() {
    gl_Position = matrix * vec4(corner, 1.0);
    at = corner;
    high = dot(corner, height) / heights + 0.5;
    int k = gl_VertexID % 3;
    place = vec3(k == 0, k == 1, k == 2);
}`,
    fragment: `#version 300 es
precision highp float;
in vec3 at;
in float high;
in vec3 place;
out vec4 pixel;
${LIGHT}
void main() {
    vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
    if (dot(normal, away) > 0.0) normal = -normal;
    vec3 wide = fwidth(place);
    vec3 inner = place / wide;
    float edge = 1.0 - smoothstep(0.3, 1.2, min(min(inner.x, inner.y), inner.z));
    float seen = 1.0 - smoothstep(0.1, 0.4, max(max(wide.x, wide.y), wide.z));
    pixel = vec4(glaze(high) * light(normal) * (1.0 - 0.5 * edge * seen), 1.0);
}`,
};
