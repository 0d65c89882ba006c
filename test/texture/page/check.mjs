// Opens pages of map_page_test.cpp in the distribution's Chromium, and uses them as a person
// would: node check.mjs CHROMIUM FOLDER. Prints what is wrong, if anything is.

import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {Browser, pause} from './browser.mjs';
import {cameraIn, pixelOf} from './camera.mjs';
import {boundsOfChange, commonestColour, frequentColours, shareDarkerThan} from './pictures.mjs';

const [, , program, folder] = process.argv;
const page_of = name => `file://${join(folder, name)}`;

// The room of map_page_test.cpp, in the frame of the map: y down, 5 x 2.5 x 4 m, of one colour.
const room = {floor: 1.5, ceiling: -1, left: -2.5, right: 2.5, front: -2, back: 2, colour: [180, 60, 45]};
const table = {plane: 6, middle: [-2, 0.8, 0.5]};
const sizes = {computer: {width: 1280, height: 800}, telephone: {width: 390, height: 844, touch: true, ratio: 2}};

const faults = [];
const told = name => text => { faults.push(`${name}: ${text}`); };

function expect(fault, holds, text) {
  if (!holds)
    fault(text);
}

const text = selector => `document.querySelector(${JSON.stringify(selector)}).textContent`;
const isHidden = selector => `document.querySelector(${JSON.stringify(selector)}).hidden`;
const number = found => Number(/([\d.]+) m\b/.exec(found)?.[1] ?? NaN);

async function shown(browser, url, size) {
  const page = await browser.open(url, size);
  await page.until(`document.body.dataset.state === 'shown'`);
  return page;
}

// Until the camera rests and the address tells where it is.
async function rested(page) {
  await pause(60);
  await page.until(`document.body.dataset.camera === 'rests'`);
}

// The picture of the map alone.
async function withoutPanels(page) {
  const set = value => page.value(`document.querySelectorAll('.panel, nav, #corner, #labels, #hint')
    .forEach(element => { element.style.visibility = '${value}'; })`);
  await set('hidden');
  const picture = await page.picture();
  await set('');
  return picture;
}

async function point(page, place) {
  return pixelOf(place, await cameraIn(page));
}

async function clickPlace(page, place) {
  await rested(page);
  await page.click(...await point(page, place));
}

async function checkFirstPicture(browser, name, size) {
  const fault = told(`first picture, ${name}`);
  const page = await browser.open('about:blank', size);
  await page.call('Page.addScriptToEvaluateOnNewDocument', {source:
    `addEventListener('DOMContentLoaded', () => { window.loading = document.getElementById('message').textContent; });`});
  await page.go(page_of('map.html'));
  await page.until(`document.body.dataset.state === 'shown'`);
  expect(fault, (await page.value('window.loading')).startsWith('Loading'), 'no text while it loads');
  await rested(page);
  const bounds = await boundsOfChange(browser, await withoutPanels(page), page.size);
  const side = await page.value(`(() => { const box = document.getElementById('side').getBoundingClientRect();
    return box.width > 0 && box.left < 20 && box.bottom > 700 ? box.right : 0; })()`);
  expect(fault, bounds.left > side && bounds.right < size.width - 4 && bounds.top > 50 && bounds.bottom < size.height - 4,
         `the map is cropped: ${JSON.stringify(bounds)}`);
  const share = Math.max((bounds.right - bounds.left) / (size.width - side), (bounds.bottom - bounds.top) / size.height);
  expect(fault, share > 0.6, `the map has only ${share.toFixed(2)} of the window: ${JSON.stringify(bounds)}`);
  await page.until(`document.body.dataset.occlusion === 'shown'`);
  for (const label of ['Dollhouse', 'Inside', 'Plan', 'Measure'])
    expect(fault, await page.value(`[...document.querySelectorAll('button')].some(b => b.textContent === '${label}')`),
           `no button ${label}`);
  expect(fault, page.errors.length === 0, `the console has ${page.errors.join('; ')}`);
  expect(fault, page.requests.length === 0, `it asks the network for ${page.requests.join(', ')}`);
  await page.close();
}

async function checkColours(browser, name, size) {
  const fault = told(`colours, ${name}`);
  for (const view of ['inside', 'dollhouse']) {
    const page = await shown(browser, `${page_of('map.html')}#view=${view}&ao=0`, size);
    await rested(page);
    const colour = await commonestColour(browser, await page.picture());
    const off = Math.max(...colour.map((level, i) => Math.abs(level - room.colour[i])));
    expect(fault, off <= 3, `${view}: ${colour} instead of ${room.colour}`);
    await page.close();
  }
}

async function checkOcclusion(browser) {
  const shares = [];
  for (const link of ['#view=inside', '#view=inside&ao=0']) {
    const page = await shown(browser, page_of('map.html') + link, sizes.computer);
    await rested(page);
    if (!link.includes('ao'))
      await page.until(`document.body.dataset.occlusion === 'shown'`);
    shares.push(await shareDarkerThan(browser, await withoutPanels(page), room.colour[0]));
    await page.close();
  }
  expect(told('occlusion'), shares[0] > shares[1] + 0.03, `corners are not darker: ${shares}`);
}

async function checkKeys(browser) {
  const fault = told('keys');
  const page = await shown(browser, `${page_of('map.html')}#ao=0`, sizes.computer);
  for (const [key, view] of [['2', 'inside'], ['3', 'plan'], ['1', 'dollhouse']]) {
    await page.key(key);
    expect(fault, await page.value('document.body.dataset.view') === view, `${key} does not show ${view}`);
    expect(fault, await page.value(`document.getElementById('${view}').getAttribute('aria-pressed')`) === 'true',
           `the button of ${view} is not pressed`);
  }
  await page.key('m');
  expect(fault, !await page.value(isHidden('#measuring')), 'm does not measure');
  await page.key('Escape');
  expect(fault, await page.value(isHidden('#measuring')), 'Escape does not end measuring');
  await page.key('?');
  expect(fault, !await page.value(isHidden('#help_text')), '? shows no help');
  await page.key('Escape');
  expect(fault, await page.value(isHidden('#help_text')), 'Escape does not close the help');
  await rested(page);
  const before = await page.value('location.hash');
  await page.drag([700, 400], [500, 430]);
  await rested(page);
  expect(fault, await page.value('location.hash') !== before, 'a drag does not turn the map');
  await page.key('h');
  await rested(page);
  expect(fault, await page.value('location.hash') === before, 'h does not lead home');
  await page.value(`document.getElementById('search').focus()`);
  await page.key('3');
  expect(fault, await page.value('document.body.dataset.view') === 'dollhouse', 'what is typed acts as a key');
  await page.close();
}

async function checkTouch(browser) {
  const fault = told('touch');
  const page = await shown(browser, `${page_of('map.html')}#ao=0`, sizes.telephone);
  await rested(page);
  await page.touch([await point(page, table.middle)]);
  await page.until(`!${isHidden('#card')}`, 5).catch(() => fault('a tap shows no card'));
  expect(fault, (await page.value(text('#name'))).includes('6'), `a tap shows ${await page.value(text('#name'))}`);
  let before = await cameraIn(page);
  await page.touch([[200, 400]], [[120, 400]]);
  await rested(page);
  let after = await cameraIn(page);
  expect(fault, Math.abs(after.at[0] - before.at[0]) > 0.2, 'a finger does not turn the map');
  before = after;
  await page.touch([[150, 400], [240, 400]], [[110, 400], [280, 400]]);
  await rested(page);
  after = await cameraIn(page);
  const distance = ({at, to}) => Math.hypot(...at.map((x, i) => x - to[i]));
  expect(fault, distance(after) < 0.9 * distance(before), 'two fingers bring nothing nearer');
  await page.press('#contents');
  expect(fault, await page.value(`getComputedStyle(document.getElementById('side')).display`) !== 'none', 'no list');
  expect(fault, page.errors.length === 0, `the console has ${page.errors.join('; ')}`);
  await page.close();
}

async function checkCards(browser) {
  const fault = told('cards');
  const page = await shown(browser, `${page_of('map.html')}#ao=0`, sizes.computer);
  await clickPlace(page, table.middle);
  await page.until(`!${isHidden('#card')}`, 5).catch(() => fault('a click shows no card'));
  await rested(page);
  expect(fault, (await page.value('location.hash')).includes(`plane=${table.plane}`), 'the link lacks the plane');
  const line = await page.value(text('#line'));
  expect(fault, /1\.00 m², 1\.0 × 1\.0 m, noise 6\.8 mm/.test(line), `the table is ${line}`);
  const link = await page.value('location.href');
  await page.key('Escape');
  expect(fault, await page.value(isHidden('#card')), 'Escape does not close the card');
  await page.close();

  const again = await shown(browser, link, sizes.computer);
  await rested(again);
  expect(fault, await again.value('location.href') === link, 'a link shows another view');
  expect(fault, !await again.value(isHidden('#card')), 'a link to a plane shows no card');
  await again.close();

  const wall = await shown(browser, `${page_of('map.html')}#plane=3&ao=0`, sizes.computer);
  await rested(wall);
  expect(fault, await wall.value(text('#name')) === 'Wall of room 1', `#plane=3 is ${await wall.value(text('#name'))}`);
  expect(fault, /door 0\.90 × 2\.00 m/.test(await wall.value(text('#openings'))), 'the card of a wall lacks its door');
  await wall.drag([700, 300], [1280, 300], 12);
  await wall.drag([700, 300], [1280, 300], 12);
  await rested(wall);
  expect(fault, await wall.value(isHidden('#card')), 'the card stays when its face has turned away');
  await wall.value(`document.getElementById('search').value = 'ceiling';
    document.getElementById('search').dispatchEvent(new Event('input'))`);
  expect(fault, await wall.value(`document.querySelectorAll('#list button:not(.room)').length`) === 1, 'the search finds something else');
  await wall.close();
}

async function checkMeasures(browser, name, size) {
  const fault = told(`measures, ${name}`);
  const page = await shown(browser, `${page_of('map.html')}#view=plan&ao=0`, size);
  const press = size.touch ? async at => page.touch([at]) : async at => page.click(...at);
  const measure = async (...places) => {
    await rested(page);
    for (const place of places)
      await press(await point(page, place));
    await pause(100);
    return page.value(text('#told'));
  };
  await page.press('#measure');
  const {left, right, front, back, floor} = room;
  const slack = 0.03; // metres that the pointer is off the corners
  const across = await measure([left + slack, floor, front + slack], [right - slack, floor, front + slack]);
  expect(fault, number(across) === 5, `between corners: ${across}`);
  const diagonal = await measure([left + slack, floor, front + slack], [right - slack, floor, back - slack]);
  expect(fault, Math.abs(number(diagonal) - Math.hypot(5, 4)) < 0.001, `between opposite corners: ${diagonal}`);
  await page.press('#dollhouse');
  await page.press('#planes');
  const from_above = '#view=dollhouse&at=6,-10,-12&to=0,0.3,0&ao=0';
  await page.value(`location.hash = '${from_above}'`);
  const level = await measure([1, floor, -1.5], table.middle);
  expect(fault, number(level) === 0.7, `floor to table: ${level}`);
  const refused = await measure([1, floor, -1.5], [-1.2, 0.5, back]);
  expect(fault, /not parallel: 90\.0°/.test(refused), `floor to wall: ${refused}`);
  const follow = async link => {
    await page.press('#measuring .close');
    await page.value(`location.hash = '#view=inside&ao=0&${link}'`);
    await page.until(`/ m( ±[^(]+)? \\(/.test(${text('#told')})`);
    return page.value(text('#told'));
  };
  const walls = await follow('planes=2,4');
  expect(fault, number(walls) === 4 && /± at least .* mm .*parallel/.test(walls), `between walls: ${walls}`);
  // 2 degrees off, 1 m before the wall in its middle
  const slanted = await follow('planes=4,7');
  expect(fault, Math.abs(number(slanted) - 1) < 0.003 && /2\.0° off/.test(slanted), `to a slanted wall: ${slanted}`);
  await page.close();
}

async function checkPlan(browser) {
  const fault = told('plan');
  const page = await shown(browser, `${page_of('map.html')}#view=plan&ao=0`, sizes.computer);
  await rested(page);
  const bounds = await boundsOfChange(browser, await withoutPanels(page), page.size);
  const {zoom} = await cameraIn(page);
  const width = (bounds.right - bounds.left) / zoom, depth = (bounds.bottom - bounds.top) / zoom;
  // with the thickness of two walls
  expect(fault, Math.abs(width - 5.14) < 0.03 && Math.abs(depth - 4.14) < 0.03, `is ${width} x ${depth} m`);
  await page.click(...await point(page, [1.5, room.floor, -1.2]));
  await page.until(`${text('#name')} === 'Floor of room 1'`, 5).catch(() => fault('a click names no floor'));
  await page.close();
}

async function checkInside(browser) {
  const fault = told('inside');
  const page = await shown(browser, `${page_of('map.html')}#view=inside&ao=0`, sizes.computer);
  await rested(page);
  const start = await cameraIn(page);
  expect(fault, Math.hypot(...start.at) < 0.01, `starts at ${start.at}`);
  await page.value(`location.hash = '#view=inside&at=-1.5,0,-1&to=0,1,0.5&ao=0'`);
  await rested(page);
  await page.click(...await point(page, [0.5, room.floor, 1.5]));
  await rested(page);
  const {at} = await cameraIn(page);
  expect(fault, Math.hypot(at[0] - 0.5, at[2] - 1.5) < 0.05 && Math.abs(at[1]) < 0.05, `a click on the floor walks to ${at}`);
  await page.close();
}

async function checkLayers(browser) {
  const fault = told('layers');
  const page = await shown(browser, `${page_of('map.html')}#ao=0`, sizes.computer);
  const names = await page.value(`[...document.querySelectorAll('[data-layer]')].map(box => box.dataset.layer).join(' ')`);
  expect(fault, names === 'surfaces fragments unseen behind outlines names way before', `has boxes ${names}`);
  expect(fault, (await page.value(text('#layers'))).includes('(1)'), 'does not count the fragment');
  await page.close();
  const bare = await shown(browser, page_of('bare.html'), sizes.computer);
  const few = await bare.value(`[...document.querySelectorAll('[data-layer]')].map(box => box.dataset.layer).join(' ')`);
  expect(fault, few === 'surfaces behind outlines', `a map without layers has boxes ${few}`);
  expect(fault, bare.errors.length === 0, `the console has ${bare.errors.join('; ')}`);
  await bare.close();
}

// Surfaces that were seen, without colours: shaded, and not hatched as if nobody had looked.
async function checkWithoutColours(browser) {
  const fault = told('without colours');
  const page = await shown(browser, `${page_of('colourless.html')}#view=inside&ao=0`, sizes.computer);
  await rested(page);
  const shades = await frequentColours(browser, await withoutPanels(page), 0.03);
  expect(fault, shades.length >= 3, `walls are not told apart: ${JSON.stringify(shades)}`);
  const names = await page.value(`[...document.querySelectorAll('[data-layer]')].map(box => box.dataset.layer).join(' ')`);
  expect(fault, !names.includes('unseen'), 'all is said to be unseen');
  expect(fault, (await page.value(text('#legend'))).includes('without colours'), 'the legend does not tell it');
  expect(fault, page.errors.length === 0, `the console has ${page.errors.join('; ')}`);
  await page.close();
}

async function checkFaults(browser) {
  const fault = told('faults');
  const html = readFileSync(join(folder, 'map.html'), 'utf8');
  const damages = {map_json: ['id="map_json">{', 'id="map_json">['], map_glb: ['id="map_glb">Z2xU', 'id="map_glb">AAAA']};
  for (const [part, [before, after]] of Object.entries(damages)) {
    const damaged = join(folder, `damaged_${part}.html`);
    writeFileSync(damaged, html.replace(before, after));
    const page = await browser.open(`file://${damaged}`, sizes.computer);
    await page.until(`document.body.dataset.state === 'failed'`).catch(() => fault(`${part} damaged is not told`));
    expect(fault, /^The map cannot be shown: .*damaged/.test(await page.value(text('#message'))),
           `${part} damaged: ${await page.value(text('#message'))}`);
    await page.close();
  }
  const blind = await Browser.start(program, ['--disable-3d-apis']);
  const page = await blind.open(page_of('map.html'), sizes.computer);
  await page.until(`document.body.dataset.state === 'failed'`).catch(() => fault('no WebGL is not told'));
  expect(fault, (await page.value(text('#message'))).includes('no WebGL'), 'the text without WebGL does not name it');
  await blind.stop();
}

const browser = await Browser.start(program);
try {
  for (const [name, size] of Object.entries(sizes)) {
    await checkFirstPicture(browser, name, size);
    await checkColours(browser, name, size);
    await checkMeasures(browser, name, size);
  }
  for (const check of [checkOcclusion, checkKeys, checkTouch, checkCards, checkPlan, checkInside, checkLayers,
                       checkWithoutColours, checkFaults])
    await check(browser);
} catch (error) {
  faults.push(error.stack);
} finally {
  await browser.stop();
}
for (const fault of faults)
  console.log(fault);
process.exitCode = faults.length > 0 ? 1 : 0;
