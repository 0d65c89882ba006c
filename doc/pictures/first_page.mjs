// Photographs pages of maps for the README: node first_page.mjs CHROMIUM PICTURES REAL.html FILMED.html
// Writes real_map.png, filmed_map.png, filmed_inside.png, and the frames of a clip, clip_000.png and so on.

import {writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {Browser, pause} from '../../test/texture/page/browser.mjs';

const [, , program, folder, real, filmed] = process.argv;
const size = {width: 960, height: 640};
const middle = [640, 320];

const save = async (page, name) => writeFileSync(join(folder, name), Buffer.from(await page.picture(), 'base64'));

async function opened(browser, file, link = '') {
  const page = await browser.open(`file://${file}${link}`, size);
  await page.until(`document.body.dataset.state === 'shown'`);
  await page.until(`document.body.dataset.occlusion === 'shown'`).catch(() => {});
  return page;
}

async function withoutPanels(page, name) {
  await page.value(`document.querySelectorAll('.panel, nav, #corner, #labels, #hint')
    .forEach(element => { element.style.visibility = 'hidden'; })`);
  await save(page, name);
}

// One frame after each small step of a hand that turns the map.
async function turned(page, clip, across, frames) {
  await page.mouse('mousePressed', middle, 1);
  for (let i = 1; i <= frames; ++i) {
    await page.mouse('mouseMoved', [middle[0] + across * i / frames, middle[1]], 1);
    await pause(120);
    await clip();
  }
  await page.mouse('mouseReleased', [middle[0] + across, middle[1]], 0);
}

async function held(clip, frames) {
  await pause(1500);
  for (let i = 0; i < frames; ++i)
    await clip();
}

const browser = await Browser.start(program);
try {
  for (const [file, link, name] of [[real, '', 'real_map.png'], [filmed, '', 'filmed_map.png'],
                                    [filmed, '#view=inside', 'filmed_inside.png']])
    await withoutPanels(await opened(browser, file, link), name);
  const page = await opened(browser, filmed);
  let number = 0;
  const clip = () => save(page, `clip_${String(number++).padStart(3, '0')}.png`);
  await held(clip, 3);
  await turned(page, clip, 260, 14);
  await page.key('2');
  await held(clip, 4);
  await turned(page, clip, -320, 14);
  await page.key('3');
  await held(clip, 8);
} finally {
  await browser.stop();
}
