// Work that takes longer than a moment: it pauses, shows how far it is, and ends when newer work
// of its kind begins.
import { reportWork } from './panel.mjs';

/** How long the page may be busy between two pauses, and before it says so, in ms. */
const [SLICE, MOMENT] = [24, 150];

/** That newer work has begun. */
export class Superseded extends Error {}

export class Work {
    #latest = 0;

    /** Begins; the function returned is to be told how much is done, often, and waited for. */
    begin(doing) {
        this.#latest += 1;
        const mine = this.#latest;
        const start = performance.now();
        let last = start;
        return async (share) => {
            if (mine !== this.#latest) throw new Superseded();
            const now = performance.now();
            if (now - last < SLICE) return;
            if (now - start > MOMENT) reportWork(doing, share);
            await new Promise((next) => setTimeout(next));
            last = performance.now();
            if (mine !== this.#latest) throw new Superseded();
        };
    }
}
