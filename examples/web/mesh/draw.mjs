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

/** What is drawn of one kind: a buffer, and how a vertex or an instance is read from it. */
function table(gl, program, name, read) {
    const [buffer, reader] = [gl.createBuffer(), gl.createVertexArray()];
    const place = gl.getAttribLocation(program, name);
    gl.bindVertexArray(reader);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(place);
    read(place);
    return { buffer, reader, count: 0 };
}

export class Picture {
    #gl;
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
        [this.#voxels, this.#triangles] = [compile(gl, VOXELS), compile(gl, TRIANGLES)];
        const faces = (place) => {
            gl.vertexAttribIPointer(place, 2, gl.UNSIGNED_INT, 8, 0);
            gl.vertexAttribDivisor(place, 1);
        };
        this.#faces = table(gl, this.#voxels.program, 'face', faces);
        this.#marked = table(gl, this.#voxels.program, 'face', faces);
        this.#soup = table(gl, this.#triangles.program, 'corner', (place) => gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 12, 0));
        gl.enable(gl.DEPTH_TEST);
        this.works = true;
    }

    #fill(into, numbers, each) {
        if (!this.works) return;
        const gl = this.#gl;
        gl.bindBuffer(gl.ARRAY_BUFFER, into.buffer);
        gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
        into.count = numbers.length / each;
    }

    set faces(faces) {
        this.#fill(this.#faces, faces, 2);
    }

    set marked(faces) {
        this.#fill(this.#marked, faces, 2);
    }

    /** Corners of triangles, measured from the middle of the mesh. */
    set soup(numbers) {
        this.#fill(this.#soup, numbers, 3);
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
            return;
        }
        this.#use(this.#voxels, view, view.matrix(grid.origin, grid.cell), [axis, grid.size[up]]);
        for (const [faces, rise, color] of [[this.#faces, 0, [0, 0, 0, 0]], [this.#marked, 0.02, [...paint, 0.85]]]) {
            gl.uniform1f(this.#voxels.at.rise, rise);
            gl.uniform4fv(this.#voxels.at.paint, color);
            gl.bindVertexArray(faces.reader);
            gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, faces.count);
        }
    }
}
