// The table of the 15 numbers. A field shows the number in use, or what was written and
// refused; a message below its row says why, and which number is kept.
import { minus, read } from './read.mjs';
import { SCALARS } from './scalar.mjs';

export const ROWS = ['a', 'b', 'c', 'centre', 'half'];

/** The number `k` of the 15, by name. */
export const nameOf = (k) => `${ROWS[Math.floor(k / 3)]}.${'xyz'[k % 3]}`;

export const isHalfExtent = (k) => k >= 12;

/** A new element. */
export function make(tag, text = '', more = {}) {
    return Object.assign(document.createElement(tag), { textContent: text }, more);
}

export class Fields {
    #cells = [];
    /** For each field a message: `refused` is the text that was refused, if one was. */
    #remarks = new Array(15).fill(null);
    #scalar = 0;
    #numbers = [];

    /** `write(k, text)` when something is written, `choose(k)` when a field is entered. */
    constructor(table, { write, choose }) {
        const head = make('tr');
        head.append(make('th'), ...['x', 'y', 'z'].map((name) => make('th', name, { scope: 'col' })));
        table.replaceChildren(head, ...ROWS.flatMap((name, r) => this.#row(name, r, write, choose)));
    }

    #row(name, r, write, choose) {
        const [row, below] = [make('tr'), make('tr', '', { className: 'remarks' })];
        const messages = make('td', '', { colSpan: 4 });
        messages.setAttribute('aria-live', 'polite');
        row.append(make('th', name, { scope: 'row' }));
        for (let i = 0; i < 3; i += 1) {
            const k = 3 * r + i;
            const cell = make('td');
            // Not the keyboard of numbers: on some phones it has no minus.
            const input = make('input', '', { ariaLabel: nameOf(k), autocomplete: 'off', spellcheck: false, enterKeyHint: 'done' });
            input.setAttribute('autocapitalize', 'off');
            input.setAttribute('aria-describedby', `remark-${k}`);
            const bits = make('small', '', { hidden: true });
            const remark = make('p', '', { id: `remark-${k}`, hidden: true });
            input.addEventListener('focus', () => choose(k));
            // A text that a script, not a key, has put there makes no `change`.
            for (const type of ['change', 'blur']) {
                input.addEventListener(type, () => {
                    if (input.value !== this.#shown(k)) write(k, input.value);
                });
            }
            input.addEventListener('keydown', ({ key }) => {
                if (key === 'Escape') this.restore(k);
            });
            cell.append(input, bits);
            row.append(cell);
            messages.append(remark);
            this.#cells.push({ input, bits, remark });
        }
        below.append(messages);
        return [row, below];
    }

    /** Says that a text was refused, and keeps showing it. */
    refuse(k, text, error) {
        this.#remark(k, { refused: text, message: error });
    }

    /** Says something about a number in use; nothing if the text is empty. */
    note(k, message) {
        this.#remark(k, message ? { refused: null, message } : null);
    }

    /** Back to the number in use. */
    restore(k) {
        this.#remark(k, null);
    }

    /** All of them back to the numbers in use. */
    restoreAll() {
        this.#cells.forEach((_, k) => this.restore(k));
    }

    #remark(k, remark) {
        this.#remarks[k] = remark;
        this.#show(k);
    }

    #inUse(k) {
        return SCALARS[this.#scalar].show(this.#numbers[k]);
    }

    /** The text in the field, unless someone is writing. */
    #shown(k) {
        return this.#remarks[k]?.refused ?? this.#inUse(k);
    }

    #show(k) {
        const { input, remark: line } = this.#cells[k];
        const remark = this.#remarks[k];
        const isRefused = remark !== null && remark.refused !== null;
        input.value = this.#shown(k);
        input.ariaInvalid = isRefused ? 'true' : null;
        line.hidden = remark === null;
        line.className = isRefused ? 'error' : 'note';
        line.replaceChildren(...remark === null ? [] : [
            make('b', nameOf(k)), ` ${remark.message}`, isRefused ? ` Kept: ${minus(this.#inUse(k))}.` : '',
        ]);
    }

    /**
     * Shows the numbers in use. A remark goes when its number has changed. With another
     * scalar a refused text stays where that scalar refuses it too.
     */
    fill(scalar, numbers, chosen, bits) {
        const isOther = scalar !== this.#scalar;
        const before = this.#numbers;
        this.#scalar = scalar;
        this.#numbers = numbers;
        this.#cells.forEach(({ input, bits: small }, k) => {
            const remark = this.#remarks[k];
            if (isOther && remark !== null) {
                const error = remark.refused === null ? '' : read(scalar, remark.refused, isHalfExtent(k)).error;
                this.#remarks[k] = error ? { refused: remark.refused, message: error } : null;
            } else if (!Object.is(numbers[k], before[k])) {
                this.#remarks[k] = null;
            }
            input.classList.toggle('chosen', k === chosen);
            small.hidden = !bits;
            small.textContent = SCALARS[scalar].hex(numbers[k]);
            this.#show(k);
        });
    }
}
