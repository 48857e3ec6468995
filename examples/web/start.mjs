// What `cargo web` does when cargo has built the module of one view: cargo runs one program at a
// time, so this builds the other one, and serves the page with both.
import { spawnSync } from 'node:child_process';
import { basename, dirname, join, resolve } from 'node:path';

import { serve } from './serve.mjs';

const VIEWS = ['web', 'web_mesh'];

/** Builds a module into the folder where cargo has put another, or ends with the reason. */
function build(view, folder) {
    const profile = basename(dirname(folder));
    const options = [
        'build', '--profile', profile === 'debug' ? 'dev' : profile, '--features', 'small,alloc',
        '--example', view, '--target', 'wasm32-unknown-unknown',
    ];
    const { status } = spawnSync(process.env.CARGO ?? 'cargo', options, { stdio: 'inherit' });
    if (status === 0) return;
    console.error(`The page needs ${view}.wasm too, and this did not build it: cargo ${options.join(' ')}`);
    process.exit(1);
}

/** Serves the page, given where the module of one view is. */
export async function start(path) {
    const folder = dirname(resolve(path));
    for (const view of VIEWS) if (`${view}.wasm` !== basename(path)) build(view, folder);
    const modules = Object.fromEntries(VIEWS.map((view) => [`${view}.wasm`, join(folder, `${view}.wasm`)]));
    const at = (port) => serve(modules, port);
    // Another port where that one is taken.
    const { address } = await at(Number(process.env.PORT ?? 8017)).catch(() => at(0));
    console.log(`The page is at ${address} until you press Ctrl-C.`);
}
