// The golden table of the teapot's voxels, held against boxes and points by mesh.mjs.
import { readFileSync } from 'node:fs';

export const golden = readFileSync(new URL('teapot.csv', import.meta.url), 'utf8').trim().split('\n').slice(1)
    .map((line) => line.split(',').map(Number))
    .map(([resolution, x, y, z, surface, solid, open]) => ({ resolution, size: [x, y, z], surface, solid, open }));
