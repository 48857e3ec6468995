// Reads the vertices and faces of an OBJ file.
import { quoted } from '../read.mjs';
import { Broken, List, MOST_TRIANGLES, coordinate, eachLine } from './numbers.mjs';

/** Positions, three numbers to a vertex, and the index, three to a triangle; faces become fans. */
export async function readObj(bytes, pause) {
    const [vertices, triangles] = [new List(Float32Array), new List(Uint32Array)];
    /** The greatest index so far that has no vertex yet. */
    let ahead = { index: 0, line: 0 };

    /** The index of a vertex from zero on; those below zero count from the last one back. */
    function index(word, line) {
        const text = word.split('/', 1)[0];
        const count = vertices.length / 3;
        if (!/^-?\d{1,9}$/.test(text) || Number(text) === 0) {
            throw new Broken(`${quoted(word)} is not the index of a vertex. The first one is 1.`, line);
        }
        const i = Number(text);
        if (i < -count) throw new Broken(`there is no vertex ${i}: there are ${count} before it.`, line);
        if (i > count && i > ahead.index) ahead = { index: i, line };
        return i < 0 ? count + i : i - 1;
    }

    await eachLine(bytes, pause, ([kind, ...words], line) => {
        if (kind === 'v') {
            if (words.length < 3) throw new Broken(`a vertex needs three numbers, and this one has ${words.length}.`, line);
            for (let i = 0; i < 3; i += 1) vertices.push(coordinate(words[i], line));
            if (vertices.length > 9 * MOST_TRIANGLES) throw new Broken('There are more vertices than so many triangles have as this page takes.');
        } else if (kind === 'f') {
            if (words.length < 3) throw new Broken(`a face needs three vertices, and this one has ${words.length}.`, line);
            const face = words.map((word) => index(word, line));
            for (let k = 2; k < face.length; k += 1) {
                triangles.push(face[0]);
                triangles.push(face[k - 1]);
                triangles.push(face[k]);
            }
            if (triangles.length > 3 * MOST_TRIANGLES) {
                throw new Broken(`There are more than ${MOST_TRIANGLES.toLocaleString('en')} triangles, the most that this page takes.`);
            }
        }
    });
    if (ahead.index > vertices.length / 3) {
        throw new Broken(`there is no vertex ${ahead.index}: the file has ${vertices.length / 3}.`, ahead.line);
    }
    return { positions: vertices.all, index: triangles.all };
}
