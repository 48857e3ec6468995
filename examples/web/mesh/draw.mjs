// Draws voxels, or triangles, by WebGL 2.
import { TRIANGLES, VOXELS } from './shaders.mjs';

function compile(gl, { vertex, fragment }) {
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    const names = ['matrix', 'right', 'up', 'away', 'height', 'heights', 'rise', 'paint'];
    return { program, at: Object.fromEntries(names.map((name) => [name, gl.getUniformLocation(program, name)])) };
}

/** Faces of voxels: a texture of two numbers for each. */
function faceTable(gl) {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    return { texture, count: 0 };
}

/** Corners of triangles: a buffer, and how it is read. */
function cornerTable(gl, program) {
    const [buffer, reader] = [gl.createBuffer(), gl.createVertexArray()];
    const place = gl.getAttribLocation(program, 'corner');
    gl.bindVertexArray(reader);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 12, 0);
    gl.bindVertexArray(null);
    return { buffer, reader, count: 0 };
}

/** How many triangles are copied in a step. */
const PART = 4096;

/** In steps, the corners of all triangles in a row, measured from the middle of the mesh. */
export function* soupOf({ positions, index }, [x, y, z]) {
    const soup = new Float32Array(3 * index.length);
    for (let k = 0; k < index.length; k += 1) {
        if (k % (3 * PART) === 0) yield k / index.length;
        const at = 3 * index[k];
        soup[3 * k] = positions[at] - x;
        soup[3 * k + 1] = positions[at + 1] - y;
        soup[3 * k + 2] = positions[at + 2] - z;
    }
    return soup;
}

export class Picture {
    #gl;
    /** How many faces are in a row of their texture. */
    #wide;
    #voxels;
    #triangles;
    #faces;
    #marked;
    #soup;
    /** Whether there is anything to draw with. */
    works = false;

    constructor(canvas) {
        this.#gl = canvas.getContext('webgl2', { antialias: true, alpha: true });
        if (!this.#gl) return;
        this.#begin();
        // The card may forget all, and come back.
        canvas.addEventListener('webglcontextlost', (event) => {
            event.preventDefault();
            this.works = false;
        });
        canvas.addEventListener('webglcontextrestored', () => {
            this.#begin();
            canvas.dispatchEvent(new Event('again'));
        });
    }

    #begin() {
        const gl = this.#gl;
        this.#wide = gl.getParameter(gl.MAX_TEXTURE_SIZE);
        [this.#voxels, this.#triangles] = [compile(gl, VOXELS), compile(gl, TRIANGLES)];
        [this.#faces, this.#marked] = [faceTable(gl), faceTable(gl)];
        this.#soup = cornerTable(gl, this.#triangles.program);
        gl.enable(gl.DEPTH_TEST);
        this.works = true;
    }

    #fill(into, faces) {
        if (!this.works) return;
        const gl = this.#gl;
        into.count = faces.length / 2;
        const rows = Math.ceil(into.count / this.#wide);
        const all = new Uint32Array(2 * this.#wide * rows);
        all.set(faces);
        gl.bindTexture(gl.TEXTURE_2D, into.texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG32UI, this.#wide, rows, 0, gl.RG_INTEGER, gl.UNSIGNED_INT, all);
    }

    set faces(faces) {
        this.#fill(this.#faces, faces);
    }

    set marked(faces) {
        this.#fill(this.#marked, faces);
    }

    /** Corners of triangles, measured from the middle of the mesh. */
    set soup(numbers) {
        if (!this.works) return;
        const gl = this.#gl;
        gl.bindBuffer(gl.ARRAY_BUFFER, this.#soup.buffer);
        gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
        this.#soup.count = numbers.length / 3;
    }

    /** What all of it needs of the view. */
    #use({ program, at }, view, matrix, [height, heights]) {
        const gl = this.#gl;
        gl.useProgram(program);
        gl.uniformMatrix4fv(at.matrix, false, matrix);
        for (const [name, axis] of Object.entries(view.frame)) if (at[name]) gl.uniform3fv(at[name], axis);
        gl.uniform3fv(at.height, height);
        gl.uniform1f(at.heights, heights);
    }

    /** Draws voxels of a grid, or the triangles around its middle; `paint` is for marked voxels. */
    draw(view, grid, areTriangles, paint) {
        if (!this.works) return;
        const gl = this.#gl;
        gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        const up = view.isYUp ? 1 : 2;
        const axis = [0, 1, 2].map((i) => (i === up ? 1 : 0));
        if (areTriangles) {
            this.#use(this.#triangles, view, view.matrix(grid.middle, 1), [axis, grid.size[up] * grid.cell]);
            gl.bindVertexArray(this.#soup.reader);
            gl.drawArrays(gl.TRIANGLES, 0, this.#soup.count);
            gl.bindVertexArray(null);
            return;
        }
        this.#use(this.#voxels, view, view.matrix(grid.origin, grid.cell), [axis, grid.size[up]]);
        for (const [faces, rise, color] of [[this.#faces, 0, [0, 0, 0, 0]], [this.#marked, 0.02, [...paint, 0.85]]]) {
            gl.uniform1f(this.#voxels.at.rise, rise);
            gl.uniform4fv(this.#voxels.at.paint, color);
            gl.bindTexture(gl.TEXTURE_2D, faces.texture);
            gl.drawArrays(gl.TRIANGLES, 0, 6 * faces.count);
        }
    }
}
