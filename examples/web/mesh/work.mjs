// Work that takes longer than a moment: it pauses, shows how far it is, and ends when newer work
// of its kind begins.
import { reportWork } from './panel.mjs';

/** How long the page may be busy between two pauses, and before it says so, in ms. */
const [SLICE, MOMENT] = [12, 150];

/** That newer work has begun. */
export class Superseded extends Error {}

export class Work {
    #latest = 0;

    /**
     * Begins; the function returned is to be told how much is done, often, and waited for. What
     * is done ends with a pause, for much may follow.
     */
    begin(doing, start = performance.now()) {
        this.#latest += 1;
        const mine = this.#latest;
        let last = performance.now();
        return async (share) => {
            if (mine !== this.#latest) throw new Superseded();
            const now = performance.now();
            if (share < 1 && now - last < SLICE) return;
            if (now - start > MOMENT) reportWork(doing, share);
            await new Promise((next) => setTimeout(next));
            last = performance.now();
            if (mine !== this.#latest) throw new Superseded();
        };
    }
}

/** How much work is not done. */
let tasks = 0;

/** Does work that lasts, until it is done or newer work supersedes it. */
export async function busily(work) {
    tasks += 1;
    document.body.dataset.busy = 'yes';
    try {
        await work();
    } catch (error) {
        if (!(error instanceof Superseded)) throw error;
    } finally {
        tasks -= 1;
        if (tasks === 0) {
            reportWork(null);
            document.body.dataset.busy = '';
        }
    }
}

/** Does steps, with pauses between them. Returns their result, and how long the steps took, in ms. */
export async function run(steps, pause) {
    let time = 0;
    try {
        for (;;) {
            const start = performance.now();
            const { done, value } = steps.next();
            time += performance.now() - start;
            if (done) return { value, time };
            await pause(value);
        }
    } finally {
        steps.return();
    }
}
