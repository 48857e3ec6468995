// Meshes as files, good ones and rubbish.

/** A cube from 0 to 1, closed. */
const CORNERS = Array.from({ length: 8 }, (_, k) => [k & 1, k >> 1 & 1, k >> 2 & 1]);
const SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
const TRIANGLES = SIDES.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);

/** As OBJ: quads, indices that count back, comments, lines that go on, and what is not used. */
export const CUBE_OBJ = [
    '# a cube', 'mtllib no.mtl', ...CORNERS.map((v) => `v ${v.join(' ')} # corner\\`), 'vt 0 0', 'vn nonsense',
    ...SIDES.map((side, k) => (k % 2 ? `f ${side.map((i) => `${i - 8}//1`).join(' ')}` : `f ${side.slice(0, 2).map((i) => i + 1).join(' ')} \\\r\n ${side.slice(2).map((i) => `${i + 1}/1`).join(' ')}`)),
].join('\r\n').concat('\\');

const FACETS = TRIANGLES.map((t) => ['facet normal 0 0 0', 'outer loop', ...t.map((i) => `  vertex ${CORNERS[i].join(' ')}`), 'endloop', 'endfacet'].join('\n'));
export const CUBE_TEXT = ['solid cube', ...FACETS, 'endsolid cube', ''].join('\n');

/** As binary STL, whose header looks like that of a text; `by` makes it larger. */
export function cubeStl(count = TRIANGLES.length) {
    const bytes = new Uint8Array(84 + 50 * TRIANGLES.length);
    bytes.set(new TextEncoder().encode('solid but binary'));
    const view = new DataView(bytes.buffer);
    view.setUint32(80, count, true);
    TRIANGLES.forEach((t, k) => t.flatMap((i) => CORNERS[i]).forEach((x, i) => view.setFloat32(84 + 50 * k + 12 + 4 * i, x, true)));
    return bytes;
}

function stlWith(x) {
    const bytes = cubeStl();
    new DataView(bytes.buffer).setFloat32(84 + 50 * 3 + 12, x, true);
    return bytes;
}

/** Files without a mesh: a name, the content, and what the page says of it. */
export const RUBBISH = [
    ['empty.obj', '', /empty/],
    ['empty.stl', '', /empty/],
    ['picture.png', 'x', /\.obj or an \.stl/],
    ['none', 'x', /\.obj or an \.stl/],
    ['text.obj', 'this is\nno mesh\n', /no triangles/],
    ['points.obj', 'v 0 0 0\nv 1 0 0\n', /no triangles/],
    ['zeros.obj', new Uint8Array(5000), /not text/],
    ['nan.obj', 'v 0 0 0\nv nan 0 0\nf 1 2 1\n', /Line 2: “nan” is not a finite number/],
    ['inf.obj', 'v 0 -Infinity 0\n', /Line 1: .*not a finite number/],
    ['huge.obj', 'v 0 0 1e39\n', /Line 1: 1e\+39 is beyond f32/],
    ['word.obj', 'v 0 zero 0\n', /Line 1: “zero” is not a number/],
    ['short.obj', 'v 0 0\n', /Line 1: a vertex needs three numbers, and this one has 2/],
    ['two.obj', 'v 0 0 0\nf 1 1\n', /Line 2: a face needs three vertices/],
    ['far.obj', 'v 0 0 0\n\nf 1 1 7\n', /Line 3: there is no vertex 7: the file has 1/],
    ['back.obj', 'v 0 0 0\nf 1 1 -2\n', /Line 2: there is no vertex -2/],
    ['zero.obj', 'v 0 0 0\nf 0 1 1\n', /Line 2: “0” is not the index/],
    ['index.obj', 'v 0 0 0\nf 1 x 1\n', /Line 2: “x” is not the index/],
    ['point.obj', 'v 1 1 1\nf 1 1 1\n', /in one point/],
    ['far-away.obj', 'v 1e9 0 0\nv 1000000064 0 0\nv 1e9 9 0\nf 1 2 3\n', /too small for their distance/],
    ['largest.obj', 'v 3.4e38 0 0\nv -3.4e38 0 0\nv 0 3.4e38 0\nf 1 2 3\n', /too large/],
    ['little.stl', 'x'.repeat(50), /too short/],
    ['early.stl', cubeStl(4_000_000_000), /ends early: it announces 4,000,000,000 triangles, and has 12/],
    ['nan.stl', stlWith(NaN), /triangle 4 is NaN/],
    ['inf.stl', stlWith(-Infinity), /triangle 4 is -Infinity/],
    ['words.stl', 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 x 0\n', /Line 5: “x” is not a number/],
    ['half.stl', 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n', /middle of a facet/],
    ['four.stl', `solid x\n${'vertex 0 0 0\n'.repeat(4)}endfacet\n`, /Line 6: a facet needs three vertices, and this one has 4/],
    ['prose.stl', 'solid ground\nis what\n', /Line 2: “is” is no word of an STL/],
];

/** A square of n × n squares, waved, as OBJ: two triangles each. */
export function waves(n) {
    const lines = [];
    for (let y = 0; y <= n; y += 1) for (let x = 0; x <= n; x += 1) lines.push(`v ${x} ${(9 * Math.sin(x / 9) * Math.cos(y / 7)).toFixed(4)} ${y}`);
    for (let y = 0; y < n; y += 1) {
        for (let x = 1; x <= n; x += 1) {
            const k = y * (n + 1) + x;
            lines.push(`f ${k} ${k + 1} ${k + n + 2} ${k + n + 1}`);
        }
    }
    return lines.join('\n');
}

/** The same as binary STL. */
export function wavesStl(n) {
    const bytes = new Uint8Array(84 + 100 * n * n);
    const view = new DataView(bytes.buffer);
    view.setUint32(80, 2 * n * n, true);
    const corners = [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]];
    for (let k = 0; k < 6 * n * n; k += 1) {
        const square = Math.floor(k / 6);
        const [x, y] = [square % n + corners[k % 6][0], Math.floor(square / n) + corners[k % 6][1]];
        const at = 84 + 50 * Math.floor(k / 3) + 12 + 12 * (k % 3);
        [x, 9 * Math.sin(x / 9) * Math.cos(y / 7), y].forEach((number, i) => view.setFloat32(at + 4 * i, number, true));
    }
    return bytes;
}
