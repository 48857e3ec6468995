// Serves the page, on this machine only.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const [FOLDER, REPOSITORY] = ['.', '../..'].map((path) => fileURLToPath(new URL(path, import.meta.url)));
/** What the page takes from the repository: where it lies is the same in both. */
const PACKAGE = /^\/bindings\/npm\/(js|dist)\//;
const TYPES = {
    '.html': 'text/html; charset=utf-8',
    '.css': 'text/css',
    '.js': 'text/javascript',
    '.mjs': 'text/javascript',
    '.wasm': 'application/wasm',
};

/** The mesh that is shown first. */
const ASSETS = { 'teapot.obj': fileURLToPath(new URL('../assets/teapot.obj', import.meta.url)) };

/** Serves the page, and under further names further files. Says at which address. */
export function serve(further, port) {
    const files = { ...ASSETS, ...further };
    const server = createServer(async (request, response) => {
        try {
            const { pathname } = new URL(request.url, 'http://localhost');
            const name = pathname.endsWith('/') ? `${pathname}index.html` : pathname;
            const bytes = await readFile(files[name.slice(1)] ?? join(PACKAGE.test(normalize(name)) ? REPOSITORY : FOLDER, normalize(name)));
            response.writeHead(200, {
                'content-type': TYPES[extname(name)] ?? 'application/octet-stream',
                'cache-control': 'no-store',
            });
            response.end(bytes);
        } catch {
            response.writeHead(404).end();
        }
    });
    return new Promise((resolve, reject) => {
        server.once('error', reject);
        server.listen(port, 'localhost', () =>
            resolve({ server, address: `http://localhost:${server.address().port}/` }));
    });
}
