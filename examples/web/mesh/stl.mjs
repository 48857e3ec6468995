// Reads the triangles of an STL file, binary or text.
import { Broken, List, MOST_TRIANGLES, coordinate, eachLine, finite } from './numbers.mjs';

const [HEADER, TRIANGLE, NORMAL] = [84, 50, 12];
/** How many triangles are read between two looks at the clock. */
const PART = 1 << 12;

const tooMany = () => new Broken(`There are more than ${MOST_TRIANGLES.toLocaleString('en')} triangles, the most that this page takes.`);

/** Each triangle has vertices of its own. */
const mesh = (positions) => ({ positions, index: null });

/** A binary file may begin with “solid” as well: its length tells. */
export function readStl(bytes, pause) {
    const words = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const count = bytes.length >= HEADER ? words.getUint32(80, true) : -1;
    const isSolid = String.fromCharCode(...bytes.subarray(0, 5)).toLowerCase() === 'solid';
    const isText = isSolid && HEADER + TRIANGLE * count !== bytes.length && !bytes.subarray(0, HEADER).includes(0);
    if (isText) return readText(bytes, pause);
    if (count < 0) throw new Broken('The file is too short for an STL file.');
    return readBinary(words, count, pause);
}

async function readBinary(words, count, pause) {
    const room = Math.floor((words.byteLength - HEADER) / TRIANGLE);
    if (count > room) {
        throw new Broken(`The file ends early: it announces ${count.toLocaleString('en')} triangles, and has ${room.toLocaleString('en')}.`);
    }
    if (count > MOST_TRIANGLES) throw tooMany();
    const vertices = new Float32Array(9 * count);
    for (let k = 0; k < count; k += 1) {
        const at = HEADER + TRIANGLE * k + NORMAL;
        for (let i = 0; i < 9; i += 1) {
            const x = words.getFloat32(at + 4 * i, true);
            if (!Number.isFinite(x)) throw new Broken(`A coordinate of triangle ${(k + 1).toLocaleString('en')} is ${x}: not a finite number.`);
            vertices[9 * k + i] = finite(x);
        }
        if (k % PART === PART - 1) await pause(k / count);
    }
    return mesh(vertices);
}

async function readText(bytes, pause) {
    const vertices = new List(Float32Array);
    /** How many vertices the present facet has. */
    let corners = 0;
    await eachLine(bytes, pause, ([kind, ...words], line) => {
        switch (kind.toLowerCase()) {
        case 'vertex':
            if (words.length < 3) throw new Broken(`a vertex needs three numbers, and this one has ${words.length}.`, line);
            for (let i = 0; i < 3; i += 1) vertices.push(coordinate(words[i], line));
            corners += 1;
            if (vertices.length > 9 * MOST_TRIANGLES) throw tooMany();
            break;
        case 'endfacet':
            if (corners !== 3) throw new Broken(`a facet needs three vertices, and this one has ${corners}.`, line);
            corners = 0;
            break;
        case 'solid': case 'endsolid': case 'facet': case 'outer': case 'endloop': break;
        default: throw new Broken(`“${kind.slice(0, 18)}” is no word of an STL file.`, line);
        }
    });
    if (corners !== 0) throw new Broken('The file ends in the middle of a facet.');
    return mesh(vertices.all);
}
