// septum: exact questions about triangle meshes, in WebAssembly.
export { init } from './memory.js';
export { Mesh } from './mesh.js';
export { inSteps } from './steps.js';
export { Voxels } from './voxels.js';
