// Reads what is written into a field: a number of the scalar, or why it is none.
import { SCALARS } from './scalar.mjs';

/** A decimal number. No digit can be matched in two ways, so long text takes linear time. */
const DECIMAL = /^[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?$/i;
const NOT_FINITE = /^[+-]?(nan|inf|infinity|∞)$/i;
const HEXADECIMAL = /^[+-]?0x/i;

/** How much of a long text a message repeats. */
const LONG = 18;

/** A number's text with the sign that messages use. */
export const minus = (text) => text.replace(/^-/, '−');

/** A text as a message repeats it. */
export function quoted(text) {
    const letters = [...text.slice(0, 4 * LONG)];
    return letters.length > LONG || text.length > 4 * LONG ? `“${letters.slice(0, LONG).join('')}…”` : `“${text}”`;
}

/** The range of a scalar, in words. */
export function range(scalar) {
    const { name, least, most, show } = SCALARS[scalar];
    return `${name} ranges from ${minus(show(least))} to ${show(most)}`;
}

function malformed(text) {
    if (text === '') return 'The field is empty.';
    if (NOT_FINITE.test(text)) return `${quoted(text)} is not a finite number.`;
    if (HEXADECIMAL.test(text)) return `${quoted(text)} is not a decimal number.`;
    const pointed = text.replace(',', '.');
    if (DECIMAL.test(pointed)) return `${quoted(text)} has a comma. Write ${quoted(pointed)}.`;
    return `${quoted(text)} is not a number.`;
}

/**
 * What a text means in a scalar: `number`, with a `note` where it was rounded to it, or
 * `error`. A half-extent must not be negative.
 */
export function read(scalar, text, isHalfExtent = false) {
    const { name, nearest, unbounded, show } = SCALARS[scalar];
    const trimmed = text.trim().replace(/^−/, '-');
    if (!DECIMAL.test(trimmed)) return { error: malformed(trimmed) };
    const value = Number(trimmed);
    const number = nearest(value);
    if (unbounded(value) !== number) return { error: `${quoted(trimmed)} is out of range. ${range(scalar)}.` };
    if (isHalfExtent && value < 0) return { error: 'A half-extent must not be negative.' };
    const isRounded = Number(show(number)) !== value;
    return { number, note: isRounded ? `${quoted(trimmed)} was rounded to ${name}: ${minus(show(number))}.` : '' };
}
