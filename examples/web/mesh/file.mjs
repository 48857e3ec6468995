// A mesh from a file, or why there is none in it.
import { Broken } from './numbers.mjs';
import { readObj } from './obj.mjs';
import { readStl } from './stl.mjs';

/** The largest file, in bytes. */
export const MOST_BYTES = 200 << 20;

const READERS = { obj: readObj, stl: readStl };

/** What was up in most files of a kind: y of OBJ, z of STL. */
export const isYUp = (name) => !/\.stl$/i.test(name);

/**
 * The mesh of a `File` or a `Blob`: positions and index, as the package takes them. `pause` is told
 * how much is done, from 0 to 1, and may throw.
 */
export async function readMesh(name, file, pause) {
    const kind = /\.([^.]*)$/.exec(name)?.[1].toLowerCase();
    if (!Object.hasOwn(READERS, kind ?? '')) throw new Broken('A mesh is an .obj or an .stl file.');
    if (file.size === 0) throw new Broken('The file is empty.');
    if (file.size > MOST_BYTES) {
        throw new Broken(`The file has ${(file.size / (1 << 20)).toFixed(0)} MB. This page takes ${MOST_BYTES / (1 << 20)} MB at most.`);
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    await pause(0);
    const mesh = await READERS[kind](bytes, pause);
    if ((mesh.index ?? mesh.positions).length === 0) throw new Broken('The file has no triangles.');
    return mesh;
}
