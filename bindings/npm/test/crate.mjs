// The comparison of the package with golden.txt, in node.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { init, Mesh } from '../js/index.js';
import * as pairs from '../js/pairs.js';
import { golden } from './stream.mjs';

const here = (path) => readFileSync(new URL(path, import.meta.url), 'utf8');

export function asTheCrate({ simd }) {
    test(`every answer has the bits of the crate, ${simd ? 'with' : 'without'} simd128`, async () => {
        assert.deepEqual(await init({ simd }), { simd });
        await pairs.init();
        const told = golden({ Mesh, ...pairs }, here('../../../examples/assets/teapot.obj'));
        assert.deepEqual(told, here('golden.txt').trimEnd().split('\n'));
    });
}
