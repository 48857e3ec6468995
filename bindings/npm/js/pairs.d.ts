import type { Part, Three, Vector } from './index.js';

export type { Part };

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

export interface Sphere {
    center: Vector;
    radius: number;
}

/** All points within the radius of the segment from a to b. */
export interface Capsule {
    a: Vector;
    b: Vector;
    radius: number;
}

/** Shapes with flat faces. */
export type Flat = Triangle | Box | OrientedBox;

export type Shape = Flat | Sphere | Capsule;

export interface Ray {
    origin: Vector;
    direction: Vector;
    near?: number;
    far?: number;
}

export interface Contact {
    /** Moves the first shape out of the second. */
    translation: Three;
    depth: number;
    normal: Three;
    /** False only if the translation is beyond f64. */
    isSufficient: boolean;
    /** The face of the first or of the second shape, or the edges, that the direction comes from; of spheres and capsules also the nearest parts. */
    features: { first: number } | { second: number } | { edges: [number, number] } | { nearest: [Part, Part] };
    points: { onFirst: Three; onSecond: Three; depth: number; parts: [Part, Part] }[];
}

/** Loads the WebAssembly, once. Await it before anything else. */
export function init(): Promise<void>;

/** Whether two shapes have a point in common, exactly, in f64: touching is overlap. */
export function overlaps(first: Flat, second: Flat): boolean;
export function overlaps(first: Sphere | Capsule, second: Triangle | Box): boolean;
export function overlaps(first: Triangle | Box, second: Sphere | Capsule): boolean;

/** The least translation that moves the first shape out of the second, and where they meet; null if they are apart or touch. */
export function contact(first: Flat, second: Flat): Contact | null;
export function contact(first: Sphere | Capsule, second: Triangle | Box): Contact | null;
export function contact(first: Triangle | Box, second: Sphere | Capsule): Contact | null;

/** Where a ray enters and leaves a box, in lengths of its direction; null if it misses. */
export function rayBox(ray: Ray, box: Box | OrientedBox): [number, number] | null;

/** Where a ray enters and leaves a sphere, likewise; both rounded outward. */
export function raySphere(ray: Ray, sphere: Sphere): [number, number] | null;
