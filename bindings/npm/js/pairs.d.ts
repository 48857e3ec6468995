import type { Three, Vector } from './index.js';

export interface Triangle {
    a: Vector;
    b: Vector;
    c: Vector;
}

export interface Box {
    min: Vector;
    max: Vector;
}

/** Turned by three unit axes at right angles, or by a unit quaternion. */
export interface OrientedBox {
    center: Vector;
    halfExtents: Vector;
    axes?: readonly [Vector, Vector, Vector];
    quaternion?: readonly number[] | { x: number; y: number; z: number; w: number };
}

export type Shape = Triangle | Box | OrientedBox;

export interface Ray {
    origin: Vector;
    direction: Vector;
    near?: number;
    far?: number;
}

export interface Part {
    kind: 'face' | 'edge' | 'vertex';
    number: number;
}

export interface Contact {
    /** Moves the first shape out of the second. */
    translation: Three;
    depth: number;
    normal: Three;
    /** False only if the translation is beyond f64. */
    isSufficient: boolean;
    /** The face of the first or of the second shape, or the edges, that the direction comes from. */
    features: { first: number } | { second: number } | { edges: [number, number] };
    points: { onFirst: Three; onSecond: Three; depth: number; parts: [Part, Part] }[];
}

/** Loads the WebAssembly, once. Await it before anything else. */
export function init(): Promise<void>;

/** Whether two shapes have a point in common, exactly, in f64: touching is overlap. */
export function overlaps(first: Shape, second: Shape): boolean;

/** The least translation that moves the first shape out of the second, and where they meet; null if they are apart or touch. */
export function contact(first: Shape, second: Shape): Contact | null;

/** Where a ray enters and leaves a box, in lengths of its direction; null if it misses. */
export function rayBox(ray: Ray, box: Box | OrientedBox): [number, number] | null;
