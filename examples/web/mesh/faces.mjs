// The faces of voxels that can be seen, and how much light their corners get.

/** The outward ways of the six faces: −x, +x, −y, +y, −z, +z. */
export const WAYS = [[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, -1], [0, 0, 1]];

/** The two axes of a face, so that its corners are 00, 10, 01 and 11 along them. */
export const ACROSS = [[1, 2], [1, 2], [2, 0], [2, 0], [0, 1], [0, 1]];

const CORNERS = [[-1, -1], [1, -1], [-1, 1], [1, 1]];

/**
 * In steps, two numbers for each face between a voxel that is set and one that is not: x, y, z and the
 * way in a byte each; and two bits for each corner, how open it is. Beyond the cut, which says
 * for y and z from which voxel to which there are any, nothing is set.
 */
export function* facesOf(words, [nx, ny, nz], [[y0, y1], [z0, z1]] = [[0, ny], [0, nz]]) {
    const rowWords = Math.ceil(nx / 32);
    const row = (y, z) => y < y0 || y >= y1 || z < z0 || z >= z1 ? -1 : (z * ny + y) * rowWords;
    const word = (at, k) => at < 0 || k < 0 || k >= rowWords ? 0 : words[at + k];
    const isSet = (x, y, z) => x >= 0 && x < nx && (word(row(y, z), x >> 5) >>> (x & 31) & 1) === 1;

    let faces = new Uint32Array(1 << 14);
    let length = 0;
    const at = [0, 0, 0];
    /** How open the four corners of a face are, from 0 to 3 each. */
    function light(x, y, z, way) {
        const [u, v] = ACROSS[way];
        const [dx, dy, dz] = WAYS[way];
        const beside = (i, j) => {
            [at[0], at[1], at[2]] = [x + dx, y + dy, z + dz];
            at[u] += i;
            at[v] += j;
            return isSet(at[0], at[1], at[2]) ? 1 : 0;
        };
        const [left, right, below, above] = [beside(-1, 0), beside(1, 0), beside(0, -1), beside(0, 1)];
        return CORNERS.reduce((all, [i, j], k) => {
            const [a, b] = [i < 0 ? left : right, j < 0 ? below : above];
            return all | (a && b ? 0 : 3 - a - b - beside(i, j)) << 2 * k;
        }, 0);
    }
    function add(x, y, z, way) {
        if (length === faces.length) {
            const more = new Uint32Array(2 * length);
            more.set(faces);
            faces = more;
        }
        faces[length] = x | y << 8 | z << 16 | way << 24;
        faces[length + 1] = light(x, y, z, way);
        length += 2;
    }

    for (let z = z0; z < z1; z += 1) {
        for (let y = y0; y < y1; y += 1) {
            yield (z - z0 + (y - y0) / (y1 - y0)) / (z1 - z0);
            const here = row(y, z);
            const beside = [row(y - 1, z), row(y + 1, z), row(y, z - 1), row(y, z + 1)];
            for (let k = 0; k < rowWords; k += 1) {
                const bits = words[here + k];
                if (bits === 0) continue;
                for (let way = 0; way < 6; way += 1) {
                    const next = way === 0 ? bits << 1 | word(here, k - 1) >>> 31
                        : way === 1 ? bits >>> 1 | word(here, k + 1) << 31 : word(beside[way - 2], k);
                    for (let open = bits & ~next; open !== 0; open &= open - 1) {
                        add(32 * k + 31 - Math.clz32(open & -open), y, z, way);
                    }
                }
            }
        }
    }
    return faces.subarray(0, length);
}
