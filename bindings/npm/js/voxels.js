// A mesh in the voxels of a grid.
import { number, options, shown, vector, whole } from './check.js';
import { answer, asFloats, asWords, module } from './memory.js';

/** How many triangles are handed over in a step. */
const PART = 4096;
const MOST = 1 << 30;

/** Why there is no grid, by the code of the module. */
const NO_GRID = [
    '', 'a number of the grid is not finite', 'all of the mesh is in one point: it has no size', 'the grid has no voxels',
    'the grid has more than 2^30 voxels along an axis', 'the grid is too large for f32',
    'the voxels are too small for their distance from zero: neighbouring planes of the grid would round to one number; take fewer voxels, or move the mesh to zero',
    'the grid is refused', 'the mesh has no triangles', 'there is no memory for so many voxels',
];

/** Voxels, a bit each: rows along x, 32 to a word, then y, then z. */
export class Voxels {
    constructor(numbers) {
        Object.assign(this, numbers);
    }

    /** Whether a voxel is set; false beyond the grid. */
    has(x, y, z) {
        const [nx, ny, nz] = this.size;
        const isThere = [x, y, z].every((k, i) => Number.isInteger(k) && k >= 0 && k < [nx, ny, nz][i]);
        return isThere && (this.words[Math.ceil(nx / 32) * (ny * z + y) + (x >>> 5)] >>> (x & 31) & 1) === 1;
    }

    /** All voxels that are set, as [x, y, z]. */
    *[Symbol.iterator]() {
        const [row, ny] = [Math.ceil(this.size[0] / 32), this.size[1]];
        for (let k = 0; k < this.words.length; k += 1) {
            for (let word = this.words[k]; word !== 0; word &= word - 1) {
                const line = Math.floor(k / row);
                yield [32 * (k % row) + 31 - Math.clz32(word & -word), line % ny, Math.floor(line / ny)];
            }
        }
    }
}

/** The numbers of a grid: as given, or around the mesh. */
function gridOf(mesh, grid, margin) {
    if (typeof grid === 'number') {
        whole('grid', grid, 1, MOST);
        const problem = module().grid_around(mesh, grid, whole('options.margin', margin, 0, 1 << 20));
        if (problem) throw new RangeError(NO_GRID[problem]);
        const [x, y, z, cell] = asFloats().subarray(answer(), answer() + 4);
        return { origin: [x, y, z], cell: [cell, cell, cell], size: [...asWords().subarray(answer() + 4, answer() + 7)] };
    }
    if (typeof grid !== 'object' || grid === null) throw new TypeError(`grid is ${shown(grid)}, not a number of voxels or { origin, cell, size }`);
    if (margin !== 0) throw new RangeError('options.margin is for a grid around the mesh');
    const origin = vector('grid.origin', grid.origin);
    const cell = typeof grid.cell === 'number' ? Array(3).fill(number('grid.cell', grid.cell)) : vector('grid.cell', grid.cell);
    cell.forEach((x, i) => { if (!(Math.fround(x) > 0)) throw new RangeError(`grid.cell[${i}] is ${x}, not positive`); });
    const size = vector('grid.size', grid.size, Number);
    size.forEach((n, i) => whole(`grid.size[${i}]`, n, 1, MOST));
    return { origin: origin.map(Math.fround), cell: cell.map(Math.fround), size };
}

/** The steps of `Mesh.voxelize`; `mesh` says the handle, and throws once there is none. */
export function voxelSteps(mesh, count, grid, given) {
    const { solid = false, margin = 0, triangles = [0, count] } = options(given, ['solid', 'margin', 'triangles']);
    if (typeof solid !== 'boolean') throw new TypeError(`options.solid is ${shown(solid)}, not true or false`);
    if (!Array.isArray(triangles) || triangles.length !== 2) throw new TypeError(`options.triangles are ${shown(triangles)}, not [from, to]`);
    const [from, to] = triangles;
    whole('options.triangles[1]', to, 0, count);
    whole('options.triangles[0]', from, 0, to);
    const numbers = gridOf(mesh(), grid, margin);
    return steps(mesh, numbers, solid, from, to);
}

function* steps(mesh, { origin, cell, size }, solid, from, to) {
    const exports = module();
    const grid = exports.grid(...origin, ...cell, ...size, Number(solid));
    if (grid < 0) throw new RangeError(NO_GRID[-grid]);
    try {
        let openRows = 0;
        const passes = solid ? ['cross', 'fill'] : ['fill'];
        for (const [k, pass] of passes.entries()) {
            for (let at = from; at < to; at += PART) {
                exports[pass](grid, mesh(), at, Math.min(at + PART, to));
                yield (k + (at - from) / (to - from)) / passes.length;
            }
            if (pass === 'cross') openRows = exports.finish(grid);
        }
        const count = exports.count(grid);
        yield 0.999;
        const at = exports.words(grid) >>> 2;
        const words = asWords().slice(at, at + Math.ceil(size[0] / 32) * size[1] * size[2]);
        return new Voxels({ origin, cell, size, words, count, openRows });
    } finally {
        exports.drop_grid(grid);
    }
}
