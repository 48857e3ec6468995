// The package answers a stream of cases as the crate does, bit for bit: golden.rs prints the
// hashes in golden.txt.
import { asTheCrate } from './crate.mjs';

asTheCrate({ simd: true });
