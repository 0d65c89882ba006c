// How long pages of maps take to their first picture, against an empty map in the same page and
// browser, and what they weigh: node map_page_times.mjs MAP.html...

import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';

import {Browser} from '../texture/page/browser.mjs';

const chromium = '/usr/bin/chromium';
const runs = 5;

function emptyGlb() {
  const text = JSON.stringify({asset: {version: '2.0'}, scene: 0, scenes: [{}]});
  const json = Buffer.from(text.padEnd(Math.ceil(text.length / 4) * 4));
  const head = Buffer.from('glTF\x02\0\0\0....', 'latin1'), chunk = Buffer.from('....JSON', 'latin1');
  head.writeUInt32LE(20 + json.length, 8);
  chunk.writeUInt32LE(json.length, 0);
  return Buffer.concat([head, chunk, json]).toString('base64');
}

// The text of an element of a page.
const partOf = (html, id) => new RegExp(`id="${id}">([^<]*)`).exec(html)[1];

const withPart = (html, id, text) => html.replace(`id="${id}">${partOf(html, id)}`, () => `id="${id}">${text}`);

function emptied(html) {
  const parts = {map_json: '{"planes":[]}', before_json: '[]', kinds_json: '{}', previews_json: '{}', map_glb: emptyGlb()};
  return Object.entries(parts).reduce((text, [id, part]) => withPart(text, id, part), html);
}

async function firstPicture(browser, path) {
  const page = await browser.open(`file://${path}`);
  await page.until(`document.body.dataset.state !== 'loading'`);
  const time = await page.value(`performance.getEntriesByName('first picture')[0]?.startTime`);
  if (!time)
    throw new Error(`${path}: ${await page.value(`document.getElementById('message').textContent`)}`);
  await page.close();
  return time;
}

const medianOf = values => values.sort((a, b) => a - b)[values.length >> 1];

const kilobytes = text => Math.round(text.length / 1000).toLocaleString('en');

async function tell(browser, path, folder) {
  const html = readFileSync(path, 'utf8');
  const empty = join(folder, 'empty.html');
  writeFileSync(empty, emptied(html));
  const times = {map: [], empty: []};
  await firstPicture(browser, empty); // shaders are compiled
  for (let i = 0; i < runs; ++i) {
    times.empty.push(await firstPicture(browser, empty));
    times.map.push(await firstPicture(browser, resolve(path)));
  }
  const [map, none] = [medianOf(times.map), medianOf(times.empty)];
  console.log(`| ${[path, kilobytes(html), kilobytes(partOf(html, 'map_json')), kilobytes(partOf(html, 'kinds_json')),
                     kilobytes(partOf(html, 'map_glb')), map.toFixed(0), none.toFixed(0), (map / none).toFixed(2)].join(' | ')} |`);
}

const folder = mkdtempSync(join(tmpdir(), 'acmap_page_'));
const browser = await Browser.start(chromium);
console.log('| page | kB | map.json | kinds | map.glb, base 64 | first picture, ms | of an empty map | ratio |');
console.log('|---|---|---|---|---|---|---|---|');
try {
  for (const path of process.argv.slice(2))
    await tell(browser, path, folder);
} finally {
  await browser.stop();
  rmSync(folder, {recursive: true});
}
