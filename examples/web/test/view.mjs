// The mesh in voxels, in a browser.
import { check } from './check.mjs';
import { CUBE_OBJ, CUBE_TEXT, RUBBISH, cubeStl, waves } from './files.mjs';
import { stalls } from './stalls.mjs';
import { golden } from './teapot.mjs';

const count = (n) => n.toLocaleString('en');
const voxels = (n) => `${count(n)} voxel${n === 1 ? '' : 's'}`;
const [TEAPOT] = golden.filter(({ resolution }) => resolution === 64);

const idle = (page) => page.until(`document.body.dataset.ready && document.body.dataset.busy === ''`);
const isSeen = (page, id) => page.evaluate(`document.getElementById('${id}').checkVisibility()`);
const bytesOf = (content) => (typeof content === 'string' ? JSON.stringify(content) : `new Uint8Array([${content}])`);

/** Drops a file on the page. */
const drop = (page, name, content) => page.evaluate(`(() => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([${bytesOf(content)}], '${name}'));
    document.getElementById('scene').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
})()`);

async function set(page, id, value) {
    await page.evaluate(`(() => {
        const input = document.getElementById('${id}');
        input.value = '${value}';
        input.dispatchEvent(new Event('input'));
    })()`);
    await idle(page);
}

async function shows(page, number) {
    await idle(page);
    return await page.text('word') === voxels(number);
}

/** How many pixels of a canvas are drawn on, seen in the frame in which it is drawn. */
const drawn = (page, id) => page.evaluate(`new Promise((tell) => {
    dispatchEvent(new Event('resize'));
    requestAnimationFrame(() => {
        const from = document.getElementById('${id}');
        const ctx = Object.assign(document.createElement('canvas'), { width: from.width, height: from.height }).getContext('2d');
        ctx.drawImage(from, 0, 0);
        const { data } = ctx.getImageData(0, 0, from.width, from.height);
        let [count, red] = [0, 0];
        for (let i = 0; i < data.length; i += 4) {
            count += data[i + 3] > 0;
            red += data[i + 3] > 200 && data[i] > 130 && data[i + 1] < 90 && data[i + 2] < 90;
        }
        tell({ count, red });
    });
})`);

async function teapot(page) {
    check(`the teapot is there at once: ${voxels(TEAPOT.surface)}`, await shows(page, TEAPOT.surface));
    const { count: pixels } = await drawn(page, 'picture');
    check(`it is drawn (${pixels} pixels)`, pixels > 20_000);
    check('it says what that took, and that the mesh is open', / ms\./.test(await page.text('why')) && /open/.test(await page.text('closed')));
    for (const { resolution, surface } of golden) {
        await set(page, 'resolution', resolution);
        check(`slider at ${resolution}: ${voxels(surface)}`, await shows(page, surface));
    }
    await page.evaluate(`document.getElementById('resolution').focus()`);
    await page.press('ArrowLeft');
    await idle(page);
    check('an arrow key moves it by one', await page.text('fineness') === '99');
    await set(page, 'resolution', 64);
    await page.click('solid');
    check(`solid: ${voxels(TEAPOT.solid)}`, await shows(page, TEAPOT.solid));
    check('it says how many rows do not close', (await page.text('why')).includes(`${TEAPOT.open} rows do not close`));
    const before = await drawn(page, 'picture');
    await set(page, 'cut', 45);
    const after = await drawn(page, 'picture');
    check(`a cut takes some of it away (${before.count} to ${after.count} pixels)`, after.count !== before.count && /18 of 40/.test(await page.text('depth')));
    await set(page, 'cut', 0);
    await page.click('surface');
    await shows(page, TEAPOT.surface);
}

async function picks(page) {
    const [x, y] = await page.middle('#scene');
    const aside = [x + 60, y + 40];
    const { red: before } = await drawn(page, 'picture');
    await page.drag(aside, aside);
    const text = await page.text('picked');
    check(`a click picks: ${text}`, /^Triangle \d+.*: it meets \d+ voxels?\.$/.test(text) && await isSeen(page, 'corners'));
    const { red } = await drawn(page, 'scene');
    const { red: marked } = await drawn(page, 'picture');
    check(`it is shown, and its voxels (${red} and ${marked} pixels)`, red > 50 && marked > before + 50);
    await page.until(`/First triangle on a ray[\\d.]+ ms/.test(document.getElementById('times').textContent)`);
    await page.drag([30, 60], [30, 60]);
    check('a click beside it picks none', /None/.test(await page.text('picked')) && (await drawn(page, 'picture')).red === before);
}

async function points(page) {
    await drop(page, 'cube.obj', CUBE_OBJ);
    await page.until(`document.getElementById('mesh').textContent.startsWith('cube.obj')`);
    await idle(page);
    const write = async (id, text) => {
        await page.evaluate(`document.getElementById('${id}').focus(); document.activeElement.select()`);
        await page.write(text);
        await page.press('Enter');
    };
    for (const [text, says] of [['0.75', /^Inside/], ['1', /^On a triangle/], ['1.0000001', /^Outside/], ['0.5', /^Inside/]]) {
        await write('x', text);
        check(`x = ${text}: ${await page.text('where')}`, says.test(await page.text('where')));
    }
    await write('y', 'abc');
    check('what is no number is refused', await isSeen(page, 'wrong') && /^Inside/.test(await page.text('where')));
    await write('y', '0.5');
    check('and a number ends that', !await isSeen(page, 'wrong'));
    await page.click('whole');
    const [x, y] = await page.middle('#scene');
    await page.drag([x, y], [x - 330, y]);
    check(`the point can be dragged out: x = ${await page.evaluate(`document.getElementById('x').value`)}`, /^Outside/.test(await page.text('where')));
}

async function keys(page) {
    await page.evaluate(`document.activeElement.blur(); document.getElementById('scene').focus({ focusVisible: true })`);
    check('the page says which keys there are', /Enter picks/.test(await page.text('hint')));
    check('a pick does not wait to be timed', await page.evaluate(`(() => {
        const [picked, times] = ['picked', 'times'].map((id) => document.getElementById(id));
        const isNew = !/First triangle/.test(times.textContent);
        document.getElementById('scene').dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true }));
        return isNew && /^Triangle/.test(picked.textContent) && !/First triangle/.test(times.textContent);
    })()`));
    await page.press('Enter');
    check('Enter picks', /^Triangle \d+/.test(await page.text('picked')));
    const before = await page.evaluate(`document.getElementById('x').value`);
    await page.press(' ');
    for (let k = 0; k < 3; k += 1) await page.press('ArrowRight');
    const after = await page.evaluate(`document.getElementById('x').value`);
    check('space bar and arrow keys move the point', before !== after && /Arrow keys move the point/.test(await page.text('hint')));
    await page.press('Escape');
    const turned = (await drawn(page, 'floor')).count;
    for (let k = 0; k < 9; k += 1) await page.press('+');
    check('+ zooms', (await drawn(page, 'floor')).count !== turned);
    await page.press('Home');
    const stops = [];
    for (let k = 0; k < 11; k += 1) {
        await page.press('Tab');
        stops.push(await page.evaluate('document.activeElement.id'));
    }
    check(`the tab key visits ${stops.join(', ')}`, stops.join() === 'whole,surface,other,resolution,cut,voxels,file,teapot,x,y,z');
}

async function files(page) {
    for (const [name, content] of [['text.stl', CUBE_TEXT], ['binary.stl', cubeStl()]]) {
        await drop(page, name, content);
        await page.until(`document.getElementById('mesh').textContent.startsWith('${name}')`);
        check(`${name} dropped: a closed cube`, await shows(page, 64 ** 3 - 62 ** 3) && /closed/.test(await page.text('closed')) &&
            (await drawn(page, 'picture')).count > 10_000);
    }
    await page.evaluate(`(() => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([${bytesOf(CUBE_OBJ)}], 'chosen.obj'));
        const input = document.getElementById('file');
        input.files = dataTransfer.files;
        input.dispatchEvent(new Event('change'));
    })()`);
    await page.until(`document.getElementById('mesh').textContent.startsWith('chosen.obj')`);
    check('a file can be chosen, too', await shows(page, 64 ** 3 - 62 ** 3));
    const wrong = [];
    for (const [name, content, says] of RUBBISH) {
        const late = ['point.obj', 'far-away.obj', 'largest.obj'].includes(name);
        await drop(page, name, content);
        await page.until(`!document.getElementById('${late ? 'banner' : 'refused'}').hidden && document.body.dataset.busy === ''`);
        const text = await page.text(late ? 'banner' : 'refused');
        if (!says.test(text)) wrong.push(`${name}: ${text}`);
        if (!late && !(await page.text('mesh')).startsWith('chosen.obj')) wrong.push(`${name}: the mesh before is gone`);
        if (late) {
            if (await page.text('word') !== 'No voxels' || (await drawn(page, 'floor')).count > 0) wrong.push(`${name}: voxels of the mesh before`);
            if (!/: 1 triangle, \d ver/.test(await page.text('mesh'))) wrong.push(`${name}: ${await page.text('mesh')}`);
            await drop(page, 'chosen.obj', CUBE_OBJ);
            await page.until(`document.getElementById('banner').hidden && document.body.dataset.busy === ''`);
        }
    }
    check(`${RUBBISH.length} files of rubbish are refused, with the reason${wrong.map((line) => `\n       ${line}`).join('')}`, wrong.length === 0);
}

async function longWork(page) {
    await page.evaluate(`window.seen = new Set(); new MutationObserver(() => {
        if (!document.getElementById('busy').hidden) seen.add(document.getElementById('doing').textContent);
    }).observe(document.getElementById('busy'), { attributes: true, subtree: true, childList: true })`);
    await drop(page, 'waves.obj', waves(250));
    await page.until(`document.getElementById('mesh').textContent.startsWith('waves.obj')`);
    await idle(page);
    const seen = await page.evaluate('[...seen].join()');
    check(`work that takes longer shows it: ${seen}`, /Reading waves\.obj…|Building the tree…|Looking for an open edge…/.test(seen) && !await isSeen(page, 'busy'));
    await drop(page, 'waves.obj', waves(250));
    await page.click('teapot');
    await page.until(`document.getElementById('mesh').textContent.startsWith('teapot.obj')`);
    check('newer work ends it', await shows(page, TEAPOT.surface));
}

async function phone(page) {
    await page.phone(390, 844);
    await idle(page);
    const small = await page.evaluate(`[...document.querySelectorAll('button, label:not([for]), input:not([type=radio])')]
        .filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < 44).map(({ id, textContent }) => id || textContent)`);
    check(`on a phone all that is touched is at least 44 px tall${small.map((name) => `, not ${name}`).join('')}`, small.length === 0);
    check('and no file is to be dropped', !/[Dd]rop /.test(await page.text('hint')));
    check('nothing is wider than the screen', await page.evaluate('document.documentElement.scrollWidth') <= 390);
    const [x, y] = await page.middle('#scene');
    const apart = (by) => [[x - by, y], [x + by, y]];
    const before = await drawn(page, 'floor');
    await page.touch([apart(40), apart(50), apart(60), apart(70)]);
    check('two fingers zoom', (await drawn(page, 'floor')).count !== before.count);
    check('and not the page', await page.evaluate('visualViewport.scale === 1 && scrollY === 0'));
    await page.tap('whole');
    await page.touch([[[x + 30, y + 20]]]);
    check('a finger picks', /^Triangle \d+/.test(await page.text('picked')));
}

/** All of it; `open` opens a page of its own, in which a script runs first. */
export async function meshInVoxels(open) {
    const page = await open();
    await page.size(1080, 760);
    await page.theme('light');
    await teapot(page);
    await picks(page);
    await points(page);
    await keys(page);
    await files(page);
    await longWork(page);
    await stalls(open, idle);
    await phone(await open());
    const without = await open(`HTMLCanvasElement.prototype.getContext = ((get) => function (kind, ...more) {
        return kind === 'webgl2' ? null : get.call(this, kind, ...more);
    })(HTMLCanvasElement.prototype.getContext)`);
    check('without WebGL a message says so, and all else works', await shows(without, TEAPOT.surface) && await isSeen(without, 'without'));
}

/** The picture of it for the documentation: a solid, cut, and a triangle that was picked. */
export async function pose(page) {
    await page.size(1180, 960, 1.5);
    await page.theme('light');
    await idle(page);
    await page.click('solid');
    await set(page, 'resolution', 100);
    await set(page, 'cut', 40);
    await idle(page);
    await page.click('whole');
    const [x, y] = await page.middle('#scene');
    await page.drag([x + 205, y + 70], [x + 205, y + 70]);
    await page.evaluate(`document.activeElement.blur(); document.querySelector('aside').scrollTo(0, 0)`);
}
