// Brings the triangle to where the verdict flips, and looks there for numbers that the
// rounded methods get wrong.
import { project } from './exact.mjs';
import { SCALARS } from './scalar.mjs';
import { mean, minus } from './vector.mjs';

/** How far to look, in units in the last place. */
export const AROUND = 24;

/** The axis with the widest gap, or the least overlap. */
export function nearest(axes) {
    return axes.reduce((best, axis, k) => axis.gap > axes[best].gap ? k : best, 0);
}

/** The numbers with the triangle moved, each to the nearest of its scalar. */
export function moved(scalar, numbers, way, first = 0, count = 9) {
    return numbers.map((x, k) =>
        k < first || k >= first + count ? x : SCALARS[scalar].nearest(x + way[k % 3]));
}

/** The numbers with number `k` so many units in the last place further up. */
export function stepped(scalar, numbers, k, n) {
    const all = [...numbers];
    all[k] = SCALARS[scalar].step(all[k], n);
    return all;
}

export const isWrong = (answer) =>
    answer.rounded !== answer.overlaps || (answer.published ?? answer.overlaps) !== answer.overlaps;

/**
 * The answers around number `k`, from `AROUND` units below to as many above; `null` where
 * the numbers are no shapes, or the scalar ends.
 */
export function strip(septum, scalar, numbers, k) {
    const { step } = SCALARS[scalar];
    return Array.from({ length: 2 * AROUND + 1 }, (_, n) => {
        const all = stepped(scalar, numbers, k, n - AROUND);
        return step(all[k], AROUND - n) === numbers[k] ? septum.ask(scalar, all) : null;
    });
}

/** The way to a place where the verdict is the opposite. */
function beyond(septum, scalar, numbers) {
    if (!septum.ask(scalar, numbers).overlaps) {
        const [a, b, c, center] = [0, 3, 6, 9].map((k) => numbers.slice(k, k + 3));
        return minus(center, mean([a, b, c]));
    }
    const axes = project(numbers);
    const { along, gap, triangle, box } = axes[nearest(axes)];
    const sign = Math.sign(triangle[0] + triangle[1] - box[0] - box[1]) || 1;
    const margin = Math.max(0.5, -gap / 100);
    return along.map((x) => x * sign * (margin - gap));
}

/**
 * The numbers with the triangle moved to where the verdict flips, within a few units in
 * the last place of one of its coordinates, and which coordinate that is: one where
 * `rounded` errs nearby, and with a number that it gets wrong, if there is one. Nothing
 * where the verdict stays the same all the way.
 */
export function touch(septum, scalar, numbers) {
    const verdict = (all) => septum.ask(scalar, all).overlaps;
    const [before, way] = [verdict(numbers), beyond(septum, scalar, numbers)];
    const at = (share) => moved(scalar, numbers, way.map((x) => x * share));
    if (verdict(at(1)) === before) return null;
    let [low, high] = [0, 1];
    for (let turn = 0; turn < 60; turn += 1) {
        const middle = (low + high) / 2;
        if (verdict(at(middle)) === before) low = middle; else high = middle;
    }
    const there = at(low);
    let flips = null;
    for (let k = 0; k < 9; k += 1) {
        const row = strip(septum, scalar, there, k);
        if (row.every((answer) => !answer || answer.overlaps === before)) continue;
        flips ??= { numbers: there, number: k, wrong: false };
        // The nearest one.
        const wrong = row.map((answer, n) => ({ n: n - AROUND, is: answer !== null && answer.rounded !== answer.overlaps }))
            .filter(({ is }) => is).sort((x, y) => Math.abs(x.n) - Math.abs(y.n))[0];
        if (wrong) {
            return { numbers: stepped(scalar, there, k, wrong.n), number: k, wrong: true };
        }
    }
    return flips ?? { numbers: there, number: 0, wrong: isWrong(septum.ask(scalar, there)) };
}
