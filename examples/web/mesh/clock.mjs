// Times questions that take microseconds: browsers' clocks are coarser.

/** How long the hand rests before a question is timed, and how long that is repeated, in ms. */
const [REST, LONG_ENOUGH] = [150, 2];

/** The mean time of a question, in ms. */
function mean(ask) {
    const start = performance.now();
    let [count, now] = [0, start];
    for (; now < start + LONG_ENOUGH; now = performance.now(), count += 8) {
        for (let k = 0; k < 8; k += 1) ask();
    }
    return (now - start) / count;
}

export class Clock {
    #timers = new Map();

    /** Times the newest question of a name, once no newer one has come for a while. */
    time(name, ask, tell) {
        clearTimeout(this.#timers.get(name));
        this.#timers.set(name, setTimeout(() => tell(mean(ask)), REST));
    }

    /** Forgets all questions. */
    stop() {
        this.#timers.forEach((timer) => clearTimeout(timer));
    }
}
