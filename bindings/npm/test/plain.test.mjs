// The same without simd128.
import { asTheCrate } from './crate.mjs';

asTheCrate({ simd: false });
