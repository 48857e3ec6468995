// What `cargo web` does when cargo has built the module of the first view: builds the package that
// the second view uses, and serves the page with both.
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

import { serve } from './serve.mjs';

const BUILD = fileURLToPath(new URL('../../bindings/npm/build', import.meta.url));

/** Serves the page, given where the module of the first view is. */
export async function start(path) {
    const { status } = spawnSync('bash', [BUILD], { stdio: 'inherit' });
    if (status !== 0) {
        console.error('The page needs the package too, and this did not build it: bindings/npm/build');
        process.exit(1);
    }
    const at = (port) => serve({ 'web.wasm': path }, port);
    // Another port where that one is taken.
    const { address } = await at(Number(process.env.PORT ?? 8017)).catch(() => at(0));
    console.log(`The page is at ${address} until you press Ctrl-C.`);
}
