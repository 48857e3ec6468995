// Scenes to begin with: a, b, c, centre and half-extents of the box.
import { SCALARS } from './scalar.mjs';
import { touch } from './touch.mjs';

const BOX = [0.1, 0.05, 0.15, 1.1, 0.9, 0.75];

export const PRESETS = {
    face: { text: 'A face', numbers: [-0.9, -1.7, 1.5, 1.7, -0.3, 1.9, -0.2, 1.6, 2.5, ...BOX] },
    normal: { text: 'The plane', numbers: [2.5, -0.8, 0, 0.1, -2.5, 0.7, 0.4, -0.4, 2.5, ...BOX] },
    edge: { text: 'An edge', numbers: [-0.3, 0.8, 2.2, -0.2, -0.5, 2.4, 1, 2.1, 0.7, ...BOX] },
    overlap: { text: 'Overlap', numbers: [-2.1, -1.2, 0.4, 1.9, -0.7, -0.3, 0.3, 1.9, 1.7, ...BOX] },
};

/** A sliver that passes an edge of the box. */
export const SLIVER = [-1.37, 2.61, 1.43, 2.83, -0.79, 0.32, 2.97, -0.61, 0.29, ...BOX];

/** The preset, in numbers of the scalar. */
export const inScalar = (scalar, numbers) => numbers.map(SCALARS[scalar].nearest);

/** The sliver brought to where the rounded method is wrong. */
export const wrongCase = (septum, scalar) => touch(septum, scalar, inScalar(scalar, SLIVER));
