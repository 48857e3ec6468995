// What the tests here have in common.

let failures = 0;

/** Says what was looked at, and counts it if it does not hold. */
export function check(what, holds) {
    console.log(`${holds ? 'ok    ' : 'FAILED'} ${what}`);
    if (!holds) failures += 1;
}

/** What to leave the process with. */
export const outcome = () => failures === 0 ? 0 : 1;
