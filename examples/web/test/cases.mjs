// Numbers to ask about: a fixed stream of them.
import { SCALARS } from '../scalar.mjs';

/** A generator of fixed pseudo-random numbers from 0 to 1 (mulberry32). */
export function random(seed) {
    let state = seed;
    return () => {
        state = state + 0x6d2b79f5 | 0;
        let t = Math.imul(state ^ state >>> 15, state | 1);
        t = t + Math.imul(t ^ t >>> 7, t | 61) ^ t;
        return ((t ^ t >>> 14) >>> 0) / 2 ** 32;
    };
}

const around = (next, size) => (next() * 2 - 1) * size;
const whole = (next, size) => Math.round(around(next, size));

/** By kind, how to draw a coordinate. */
const KINDS = {
    random: (next) => around(next, 3),
    grid: (next) => whole(next, 3),
    'off the grid by a unit': (next) => SCALARS[0].step(whole(next, 3), whole(next, 1)),
    'far away': (next) => 1e4 + around(next, 2),
    tiny: (next) => around(next, 8) * 2 ** -149,
    huge: (next) => around(next, 3.4e38),
    'of any magnitude': (next) => around(next, 1) * 2 ** whole(next, 140),
};

/** `count` cases of each kind: its name and 15 numbers. */
export function* cases(scalar, seed, count) {
    const next = random(seed);
    const { nearest } = SCALARS[scalar];
    for (const [kind, draw] of Object.entries(KINDS)) {
        for (let k = 0; k < count; k += 1) {
            const numbers = Array.from({ length: 15 }, () => nearest(draw(next)));
            // One in four is a sliver, or less.
            if (k % 4 === 0) for (let i = 0; i < 3; i += 1) numbers[6 + i] = SCALARS[scalar].step(numbers[i], whole(next, 2));
            for (let i = 12; i < 15; i += 1) numbers[i] = nearest(Math.abs(numbers[i]));
            if (numbers.every(Number.isFinite)) yield { kind, numbers };
        }
    }
}
