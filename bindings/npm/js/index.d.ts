/** Three numbers. Meshes have f32: numbers are rounded to it. */
export type Vector = readonly [number, number, number] | Float32Array | Float64Array | readonly number[] | { readonly x: number; readonly y: number; readonly z: number };
export type Three = [number, number, number];
export type Numbers = Float32Array | Float64Array | Int8Array | Uint8Array | Int16Array | Uint16Array | Int32Array | Uint32Array | readonly number[];

/** Loads the WebAssembly, once: that with vectors (simd128) where there are, but for `simd: false`. Await it before anything else. */
export function init(options?: { simd?: boolean }): Promise<{ simd: boolean }>;

export interface RayOptions {
    /** Where the ray begins and ends, in lengths of its direction: 0 and Infinity. */
    near?: number;
    far?: number;
    /** The side of triangles that is not hit: 'none'. Front is where corners go counterclockwise. */
    cull?: 'none' | 'back' | 'front';
}

export interface Hit {
    triangle: number;
    /** The distance in lengths of the direction. */
    t: number;
    /** The barycentric coordinates of the second and the third corner. */
    u: number;
    v: number;
    /** Whether the front is hit. */
    isFront: boolean;
    point: Three;
    /** The unit normal of the triangle, out of its front. */
    normal: Three;
}

/** Hits of many rays. A ray without a hit has the triangle -1. */
export interface Hits {
    triangle: Int32Array;
    t: Float32Array;
    u: Float32Array;
    v: Float32Array;
}

export interface BoxHit {
    triangle: number;
    /** The part of the motion until then, from 0 to 1; never late. */
    t: number;
    /** The unit normal of the obstacle; null if they meet at the start. */
    normal: Three | null;
}

/** A part of a shape: of a triangle its face, an edge or a vertex. */
export interface Part {
    kind: 'face' | 'edge' | 'vertex';
    number: number;
}

export interface SphereHit {
    triangle: number;
    /** The part of the motion until then, from 0 to 1; never late. */
    t: number;
    /** The face, edge or vertex at the point of contact; null if they meet at the start. */
    part: Part | null;
}

export interface ClosestPoint {
    triangle: number;
    /** On the triangle; each coordinate rounded once. */
    point: Three;
    /** Between both points, rounded. */
    distance: number;
    /** The face, edge or vertex that the point lies on: exact. */
    part: Part;
}

/** A contact with a triangle. */
export interface MeshContact {
    triangle: number;
    /** Moves the sphere or the capsule out of the triangle. */
    translation: Three;
    depth: number;
    normal: Three;
    /** False only if the translation is beyond f32. */
    isSufficient: boolean;
    /** Whether an interior edge holds it to the triangle's normal. */
    isHeld: boolean;
    /** On the triangle. */
    point: Three;
    part: Part;
}

/** Cubes from `origin` on, or boxes. */
export interface Grid {
    origin: Vector;
    cell: number | Vector;
    size: readonly number[];
}

export interface VoxelOptions {
    /** Also the voxels whose centres are inside: false. */
    solid?: boolean;
    /** How many more layers there are on each side of the mesh: 0. */
    margin?: number;
    /** Only the triangles from one number to another. */
    triangles?: [number, number];
}

/** Voxels, a bit each: rows along x, 32 to a word, then y, then z. Iterates over those that are set. */
export class Voxels implements Iterable<Three> {
    private constructor();
    readonly origin: Three;
    readonly cell: Three;
    readonly size: Three;
    readonly words: Uint32Array;
    readonly count: number;
    /** Rows along x that cross the mesh an odd number of times: they have no inside. */
    readonly openRows: number;
    has(x: number, y: number, z: number): boolean;
    [Symbol.iterator](): IterableIterator<Three>;
}

/** Work in steps: each yields the share that is done. */
export type Steps<T> = Generator<number, T, void>;

/** Does the steps, and lets the page work after every `slice` milliseconds: 8. */
export function inSteps<T>(steps: Steps<T>, options?: { slice?: number; progress?: (share: number) => void; signal?: AbortSignal }): Promise<T>;

/** What three.js's `BufferGeometry` has. */
export interface Geometry {
    attributes: object;
    index?: object | null;
}

/** Triangles, and a tree over them. All verdicts are exact for the numbers in f32; touching is overlap. */
export class Mesh {
    /** From positions, three numbers to a vertex, and an index, three to a triangle. */
    constructor(positions: Numbers, index?: Numbers | null);
    static steps(positions: Numbers, index?: Numbers | null): Steps<Mesh>;
    static fromGeometry(geometry: Geometry): Mesh;
    static geometrySteps(geometry: Geometry): Steps<Mesh>;

    readonly vertexCount: number;
    readonly triangleCount: number;
    readonly positions: Float32Array;
    readonly index: Uint32Array;
    readonly bounds: { min: Three; max: Three } | null;
    corners(triangle: number): [Three, Three, Three];

    /** The first hit; of several at one point that of the least triangle. */
    raycast(origin: Vector, direction: Vector, options?: RayOptions): Hit | null;
    raycastAny(origin: Vector, direction: Vector, options?: RayOptions): boolean;
    /** All hits by t. */
    raycastAll(origin: Vector, direction: Vector, options?: RayOptions): Hit[];
    /** Six numbers to a ray: origin and direction. */
    raycastMany(rays: Numbers, options?: RayOptions): Hits;
    /** 1 for each ray that hits, else 0. */
    raycastAnyMany(rays: Numbers, options?: RayOptions): Uint8Array;

    /** Inside a closed mesh, or on a triangle. */
    contains(point: Vector): boolean;
    locate(point: Vector): 'outside' | 'inside' | 'on';
    containsMany(points: Numbers): Uint8Array;

    overlapsBox(min: Vector, max: Vector): boolean;
    trianglesInBox(min: Vector, max: Vector): Uint32Array;
    /** Whether a triangle is no farther from a point than a radius. */
    overlapsSphere(center: Vector, radius: number): boolean;
    trianglesInSphere(center: Vector, radius: number): Uint32Array;
    /** The closest point of all triangles, at most `within` away, rounded to f32: Infinity. Of triangles as near, the first. */
    closestPoint(point: Vector, options?: { within?: number }): ClosestPoint | null;
    /** The distance from a closed mesh, rounded; negative inside, exactly. Null without a triangle. */
    signedDistance(point: Vector): number | null;
    /** Whether two surfaces have a point in common. */
    overlapsMesh(other: Mesh): boolean;
    /** Pairs of triangles of two meshes that overlap: [a, b, a, b, …]. */
    overlappingPairs(other: Mesh, limit?: number): Uint32Array;
    /** The first triangle that a box meets on its way. */
    boxCast(min: Vector, max: Vector, motion: Vector): BoxHit | null;
    /** The first triangle that a sphere meets on its way. */
    sphereCast(center: Vector, radius: number, motion: Vector): SphereHit | null;
    /** Contacts with all triangles that a sphere or a capsule penetrates, by triangle. Interior edges catch nothing. */
    sphereContacts(center: Vector, radius: number): MeshContact[];
    capsuleContacts(a: Vector, b: Vector, radius: number): MeshContact[];

    /** An edge of an odd number of triangles, as two vertices; null if the mesh is closed. */
    openEdge(): [number, number] | null;
    openEdgeSteps(): Steps<[number, number] | null>;

    /** In a grid, or in cubes around the mesh, so many along its longest side. */
    voxelize(grid: number | Grid, options?: VoxelOptions): Voxels;
    voxelizeSteps(grid: number | Grid, options?: VoxelOptions): Steps<Voxels>;

    /** Gives the memory back at once; else it comes back when the mesh is collected. */
    free(): void;
}
