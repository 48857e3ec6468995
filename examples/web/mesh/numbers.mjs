// Numbers of a file, and lists of them that grow.
import { minus, quoted } from '../read.mjs';

/** The most triangles. */
export const MOST_TRIANGLES = 500_000;

/** What is wrong with a file, and in which line, if it has lines. */
export class Broken extends Error {
    constructor(message, line = 0) {
        super(line ? `Line ${line.toLocaleString('en')}: ${message}` : message);
    }
}

/** A list of numbers of one type, in memory that doubles as it is needed. */
export class List {
    #numbers;
    length = 0;

    constructor(Type) {
        this.#numbers = new Type(1 << 12);
    }

    push(x) {
        if (this.length === this.#numbers.length) {
            const more = new this.#numbers.constructor(2 * this.length);
            more.set(this.#numbers);
            this.#numbers = more;
        }
        this.#numbers[this.length] = x;
        this.length += 1;
    }

    /** All of them. */
    get all() {
        return this.#numbers.subarray(0, this.length);
    }
}

/** A coordinate as the nearest `f32`, or why it is none. */
export function coordinate(text, line) {
    const x = Number(text);
    if (text === '' || Number.isNaN(x)) {
        const isNan = /^[+-]?nan/i.test(text);
        throw new Broken(isNan || /^[+-]?inf/i.test(text)
            ? `${quoted(text)} is not a finite number.` : `${quoted(text)} is not a number.`, line);
    }
    return finite(x, line);
}

/** The nearest `f32`, if it is finite. */
export function finite(x, line = 0) {
    const rounded = Math.fround(x);
    if (Number.isFinite(rounded)) return rounded;
    throw new Broken(Number.isFinite(x)
        ? `${minus(String(x))} is beyond f32, which ends at 3.4e38.` : `A coordinate is ${minus(String(x))}: not a finite number.`, line);
}

/** How many bytes of text are read at a time. */
const PART = 1 << 15;
const NEWLINE = 10;
/** The longest line that is no sign of another kind of file. */
const LONGEST = 1 << 16;

/**
 * Hands the lines of a text to `take(words, line)`, part by part: its words without those of a
 * comment. `pause` is told between parts how much is done, from 0 to 1.
 */
export async function eachLine(bytes, pause, take) {
    if (bytes.subarray(0, 1 << 12).includes(0)) throw new Broken('The file is not text.');
    const decoder = new TextDecoder();
    let [line, begun] = [0, ''];
    const takeWords = (text, line) => {
        const words = text.trim().split(/\s+/);
        if (words[0] !== '') take(words, line);
    };
    for (let from = 0; from < bytes.length;) {
        // To the end of a line, so that no letter is torn.
        const end = bytes.indexOf(NEWLINE, Math.min(from + PART, bytes.length - 1));
        const to = end < 0 ? bytes.length : end + 1;
        const text = decoder.decode(bytes.subarray(from, to));
        const lines = text.split(/\r\n|\n|\r/);
        if (text.endsWith('\n')) lines.pop();
        for (const part of lines) {
            line += 1;
            if (part.length > LONGEST) throw new Broken('The line is too long for a mesh.', line);
            // A comment ends with its line, also with one that is to go on.
            const comment = part.indexOf('#');
            if (comment < 0 && part.endsWith('\\')) {
                begun += `${part.slice(0, -1)} `;
                continue;
            }
            takeWords(begun + (comment < 0 ? part : part.slice(0, comment)), line);
            begun = '';
        }
        from = to;
        await pause(from / bytes.length);
    }
    takeWords(begun, line);
}
