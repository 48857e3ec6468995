// Three numbers at a time, and polygons of them. For drawing only: it rounds.

export const add = (a, b, by = 1) => a.map((x, i) => x + b[i] * by);
export const minus = (a, b) => a.map((x, i) => x - b[i]);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
    a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];
export const unit = (a) => {
    const length = Math.hypot(...a);
    return length > 0 ? a.map((x) => x / length) : [0, 0, 0];
};
export const mean = (points) =>
    [0, 1, 2].map((i) => points.reduce((sum, p) => sum + p[i], 0) / points.length);

/** What of a polygon, or of a segment, lies where `side` is at least zero. */
export function clip(points, side) {
    const kept = [];
    points.forEach((p, k) => {
        const q = points[(k + 1) % points.length];
        const [at, next] = [side(p), side(q)];
        if (at >= 0) kept.push(p);
        if (at >= 0 !== next >= 0) kept.push(add(p, minus(q, p), at / (at - next)));
    });
    return kept;
}

/** The point of a segment that is nearest to `q`. */
function nearestOnSegment([a, b], q) {
    const way = minus(b, a);
    const share = dot(minus(q, a), way) / (dot(way, way) || 1);
    return add(a, way, Math.min(Math.max(share, 0), 1));
}

/** The point of a point, a segment or a triangle that is nearest to `q`. */
export function nearestOn(points, q) {
    if (points.length === 1) return points[0];
    const edges = points.map((p, k) => [p, points[(k + 1) % points.length]]);
    const normal = points.length > 2 ? unit(cross(minus(...edges[0]), minus(...edges[1]))) : [0, 0, 0];
    const onPlane = add(q, normal, -dot(normal, minus(q, points[0])));
    const inside = ([a, b]) => dot(cross(minus(b, a), minus(onPlane, a)), normal) >= 0;
    if (dot(normal, normal) > 0 && edges.every(inside)) return onPlane;
    return edges.map((edge) => nearestOnSegment(edge, q))
        .reduce((best, p) => Math.hypot(...minus(p, q)) < Math.hypot(...minus(best, q)) ? p : best);
}

/** The six faces of a box: outward axis, its sign, distance from `p`, corners. */
export function faces(center, half) {
    return [0, 1, 2].flatMap((i) => [-1, 1].map((sign) => {
        const [j, k] = [(i + 1) % 3, (i + 2) % 3];
        const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([s, t]) => {
            const p = [...center];
            p[i] += sign * half[i];
            p[j] += s * half[j];
            p[k] += t * half[k];
            return p;
        });
        return { i, sign, corners, outside: (p) => sign * (p[i] - center[i]) - half[i] };
    }));
}
