// Reads the map that the page holds, and shows it.

import {readData} from './data.js';
import {Picture} from './picture.js';
import {Viewer} from './viewer.js';
import {World} from './world.js';

function fail(text) {
  document.body.dataset.state = 'failed';
  document.getElementById('message').textContent = text;
}

function hasWebGL() {
  return Boolean(document.createElement('canvas').getContext('webgl2'));
}

function summaryOf(map) {
  const count = (list, one, many) => list?.length > 0 ? [`${list.length} ${list.length === 1 ? one : many}`] : [];
  const area = (map.rooms ?? []).reduce((sum, room) => sum + room.area, 0);
  return [...count(map.rooms, 'room', 'rooms'), ...(area > 0 ? [`${area.toFixed(0)} m²`] : []),
          ...count(map.planes, 'surface', 'surfaces')].join(' · ');
}

const twoFrames = () => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));

async function start() {
  if (!hasWebGL())
    return fail('This browser cannot draw the map, because it has no WebGL. Another browser, ' +
                'or hardware acceleration in its settings, may help.');
  try {
    const data = readData();
    const picture = new Picture(document.getElementById('picture'));
    const world = await World.load(data, picture.renderer);
    document.getElementById('summary').textContent = summaryOf(data.map);
    const viewer = new Viewer(world, picture);
    viewer.start();
    await twoFrames();
    performance.mark('first picture');
    document.body.dataset.state = 'shown';
    await world.finish();
    viewer.changed();
    document.body.dataset.textures = 'whole';
  } catch (error) {
    console.error(error);
    fail(`The map cannot be shown: ${error.message}`);
  }
}

// after the text that says so is there
requestAnimationFrame(() => setTimeout(start));
