// Work in steps, so that a page need not wait for it.
import { options, shown } from './check.js';

/** Does all steps, and returns the result. */
export function atOnce(steps) {
    for (;;) {
        const { done, value } = steps.next();
        if (done) return value;
    }
}

/** To the end of the queue of events: sooner than a timer, which browsers slow down. */
const nextTurn = typeof MessageChannel === 'undefined' ? () => new Promise((next) => { setTimeout(next); }) : () => new Promise((next) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
        port1.close();
        next();
    };
    port2.postMessage(null);
});

/**
 * Does the steps, and lets the page work after every `slice` milliseconds. `progress` is told the
 * share that is done; an abort of `signal` ends the work.
 */
export async function inSteps(steps, given) {
    const { slice = 8, progress, signal } = options(given, ['slice', 'progress', 'signal']);
    if (typeof steps?.next !== 'function') throw new TypeError(`steps are ${shown(steps)}, not those of Mesh.steps, voxelizeSteps or openEdgeSteps`);
    if (typeof slice !== 'number' || !(slice >= 0)) throw new RangeError(`options.slice is ${shown(slice)}, not a number of milliseconds`);
    if (progress !== undefined && typeof progress !== 'function') throw new TypeError(`options.progress is ${shown(progress)}, not a function`);
    if (signal !== undefined && typeof signal?.throwIfAborted !== 'function') throw new TypeError(`options.signal is ${shown(signal)}, not an AbortSignal`);
    try {
        let last = performance.now();
        for (;;) {
            signal?.throwIfAborted();
            const { done, value } = steps.next();
            if (done) return value;
            if (performance.now() - last >= slice) {
                progress?.(value);
                await nextTurn();
                last = performance.now();
            }
        }
    } finally {
        steps.return?.();
    }
}
