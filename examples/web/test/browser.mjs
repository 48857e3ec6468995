// A headless Chromium, driven through its own pipe: what a message is called and
// answers is its DevTools protocol. A page that does not answer in time is frozen.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** How long a page may take to answer, in ms. */
const PATIENCE = 60_000;

/** The codes of the keys that are more than a character. */
const CODES = {
    Tab: 9, Enter: 13, Escape: 27, ' ': 32, PageUp: 33, PageDown: 34, Home: 36,
    ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Delete: 46,
};

export class Browser {
    #process;
    #folder = mkdtempSync(join(tmpdir(), 'septum-web-'));
    #waiting = new Map();
    #last = 0;
    #rest = '';
    /** Uncaught errors, and what a page wrote to its console as an error. */
    errors = [];

    constructor(program) {
        this.#process = spawn(program, [
            '--headless', '--no-sandbox', '--disable-gpu', '--no-first-run', '--hide-scrollbars',
            '--disable-dev-shm-usage', '--disable-background-networking', '--disable-extensions',
            `--user-data-dir=${this.#folder}`, '--remote-debugging-pipe',
        ], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
        this.#process.on('exit', (code) => {
            for (const { reject } of this.#waiting.values()) reject(new Error(`the browser ended (${code})`));
        });
        this.#process.stdio[4].setEncoding('utf8').on('data', (text) => {
            const messages = (this.#rest + text).split('\0');
            this.#rest = messages.pop();
            messages.map((message) => JSON.parse(message)).forEach((message) => this.#hear(message));
        });
    }

    #hear({ id, result, error, method, params }) {
        if (method === 'Runtime.exceptionThrown') {
            this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
        }
        if (method === 'Runtime.consoleAPICalled' && params.type === 'error') {
            this.errors.push(params.args.map(({ value }) => value).join(' '));
        }
        const waiting = this.#waiting.get(id);
        if (!waiting) return;
        this.#waiting.delete(id);
        if (error) waiting.reject(new Error(`${waiting.method}: ${error.message}`)); else waiting.resolve(result);
    }

    send(method, params = {}, sessionId = undefined) {
        this.#last += 1;
        const id = this.#last;
        this.#process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
        return new Promise((resolve, reject) => {
            const timer = setTimeout(() => {
                this.#waiting.delete(id);
                reject(new Error(`frozen: no answer to ${method} in ${PATIENCE / 1000} s`));
            }, PATIENCE);
            const ended = (settle) => (value) => {
                clearTimeout(timer);
                settle(value);
            };
            this.#waiting.set(id, { resolve: ended(resolve), reject: ended(reject), method });
        });
    }

    /** Opens a page; `script` runs in it before all of its own. */
    async open(address, script = '') {
        const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
        const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
        const send = (method, params) => this.send(method, params, sessionId);
        await send('Runtime.enable');
        await send('Page.enable');
        await send('Page.bringToFront');
        if (script) await send('Page.addScriptToEvaluateOnNewDocument', { source: script });
        await send('Page.navigate', { url: address });
        return new Page(send);
    }

    async close() {
        const ended = new Promise((end) => this.#process.once('exit', end));
        this.send('Browser.close').catch(() => {});
        const timer = setTimeout(() => this.#process.kill('SIGKILL'), 5000);
        await ended;
        clearTimeout(timer);
        rmSync(this.#folder, { recursive: true, force: true, maxRetries: 5 });
    }
}

class Page {
    #send;

    constructor(send) {
        this.#send = send;
    }

    /** What an expression is in the page; a promise is waited for. */
    async evaluate(expression) {
        const { result, exceptionDetails } = await this.#send('Runtime.evaluate', {
            expression, awaitPromise: true, returnByValue: true,
        });
        if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        return result.value;
    }

    /** Waits until an expression is true. */
    async until(expression, seconds = 30) {
        const end = Date.now() + seconds * 1000;
        while (!await this.evaluate(expression).catch(() => false)) {
            if (Date.now() > end) throw new Error(`not in ${seconds} s: ${expression}`);
            await new Promise((next) => setTimeout(next, 50));
        }
    }

    text(id) {
        return this.evaluate(`document.getElementById('${id}').textContent`);
    }

    /** The middle of what a selector finds, scrolled to where it is seen. */
    middle(selector) {
        return this.evaluate(`(() => {
            const element = document.querySelector('${selector}');
            element.scrollIntoView({ block: 'nearest', behavior: 'instant' });
            const { left, top, width, height } = element.getBoundingClientRect();
            return [left + width / 2, top + height / 2];
        })()`);
    }

    /** Clicks on what has this id, where it is seen. */
    async click(id) {
        const at = await this.middle(`#${id}`);
        await this.drag(at, at);
    }

    /** Taps with a finger on what has this id. */
    async tap(id) {
        const at = await this.middle(`#${id}`);
        await this.touch([[at]]);
    }

    /** Puts fingers down at the first pixels, moves them through the others, and lifts them. */
    async touch([first, ...rest]) {
        const send = (type, fingers) => this.#send('Input.dispatchTouchEvent', {
            type, touchPoints: fingers.map(([x, y], id) => ({ x, y, id })),
        });
        await send('touchStart', first);
        for (const fingers of rest) await send('touchMove', fingers);
        await send('touchEnd', []);
    }

    /** Presses a key and lets it go. */
    async press(key, { shift = false } = {}) {
        const text = key.length === 1 ? key : key === 'Enter' ? '\r' : undefined;
        const event = {
            key, text, modifiers: shift ? 8 : 0,
            windowsVirtualKeyCode: CODES[key] ?? key.toUpperCase().charCodeAt(0),
        };
        await this.#send('Input.dispatchKeyEvent', { ...event, type: text ? 'keyDown' : 'rawKeyDown' });
        await this.#send('Input.dispatchKeyEvent', { ...event, type: 'keyUp' });
    }

    /** Writes a text where the focus is, over what is selected there. */
    async write(text) {
        if (text === '') await this.press('Delete');
        else await this.#send('Input.insertText', { text });
    }

    /** Presses the mouse at one pixel, moves, and lets go at another. */
    async drag(from, to, steps = 8) {
        const mouse = (type, [x, y], buttons) =>
            this.#send('Input.dispatchMouseEvent', { type, x, y, buttons, button: 'left', clickCount: 1 });
        await mouse('mouseMoved', from, 0);
        await mouse('mousePressed', from, 1);
        for (let k = 1; k <= steps && (from[0] !== to[0] || from[1] !== to[1]); k += 1) {
            await mouse('mouseMoved', from.map((x, i) => x + (to[i] - x) * k / steps), 1);
        }
        await mouse('mouseReleased', to, 0);
    }

    size(width, height, deviceScaleFactor = 1) {
        return this.#send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor, mobile: false });
    }

    /** A phone with a screen for fingers. */
    async phone(width, height) {
        await this.#send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 2, mobile: true });
        await this.#send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 5 });
    }

    theme(name) {
        return this.#send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: name }] });
    }

    /** Waits until all is drawn. */
    drawn() {
        return this.evaluate('new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)))');
    }

    /** A picture of it, as PNG. */
    async picture() {
        await this.drawn();
        const { data } = await this.#send('Page.captureScreenshot', { format: 'png' });
        return Buffer.from(data, 'base64');
    }
}
