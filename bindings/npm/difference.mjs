// Patches that make one file of another one, after C. Percival's bsdiff (2003): code that moved still
// agrees in most bytes, so that their differences are mostly zero, and small once deflated.

/** A match begins with so many equal bytes, and is worth a step if it has so many more than going on. */
const SEED = 12;
const GAIN = 8;
/** Of the places that begin alike, so many are tried. */
const TRIED = 200;

/** Up to which of `count` bytes the sum of `score` is the greatest. */
function best(count, score) {
    let [sum, most, end] = [0, 0, 0];
    for (let k = 0; k < count; k += 1) {
        sum += score(k);
        if (sum > most) [most, end] = [sum, k + 1];
    }
    return end;
}

/**
 * The patch that makes `now` of `old`: the number of steps, and three numbers for each, in words;
 * then the differences, then new bytes. A step adds differences to so many bytes of `old`, takes so
 * many new bytes, and skips so many bytes of `old`.
 */
export function difference(old, now) {
    const places = new Map();
    const seed = (bytes, at) => bytes.latin1Slice(at, at + SEED);
    for (let at = 0; at + SEED <= old.length; at += 1) {
        const begin = seed(old, at);
        if (places.has(begin)) places.get(begin).push(at);
        else places.set(begin, [at]);
    }
    const longest = (at) => {
        let [length, from] = [0, 0];
        for (const place of (places.get(seed(now, at)) ?? []).slice(0, TRIED)) {
            let k = SEED;
            while (at + k < now.length && old[place + k] === now[at + k]) k += 1;
            if (k > length) [length, from] = [k, place];
        }
        return [length, from];
    };

    const [steps, differences, added] = [[], [], []];
    // From `start` on, byte k of `now` is compared with byte k + `shift` of `old`.
    let [start, shift] = [0, 0];
    const agrees = (k, by) => (old[k + by] === now[k] ? 1 : 0);
    const close = (end, next) => {
        const score = (k, by) => (k + by < 0 || k + by >= old.length ? -Infinity : 2 * agrees(k, by) - 1);
        let kept = start + best(end - start, (k) => score(start + k, shift));
        let begin = end - (next === null ? 0 : best(end - start, (k) => score(end - 1 - k, next)));
        if (begin < kept) {
            const from = begin;
            begin += best(kept - from, (k) => agrees(from + k, shift) - agrees(from + k, next));
            kept = begin;
        }
        for (let k = start; k < kept; k += 1) differences.push(now[k] - old[k + shift] & 255);
        added.push(...now.subarray(kept, begin));
        steps.push(kept - start, begin - kept, next === null ? 0 : begin + next - (kept + shift));
        [start, shift] = [begin, next];
    };
    let at = 0;
    while (at + SEED <= now.length) {
        const [length, from] = longest(at);
        const same = Array.from({ length }, (_, k) => agrees(at + k, shift)).reduce((sum, x) => sum + x, 0);
        if (same + GAIN < length) close(at, from - at);
        at += same === length || same + GAIN < length ? Math.max(length, 1) : 1;
    }
    close(now.length, null);
    const words = Int32Array.of(steps.length / 3, ...steps);
    return Buffer.concat([Buffer.from(words.buffer), Buffer.from(differences), Buffer.from(added)]);
}
