// The link of what is shown: the part of the page's address behind #.

import {Vector3} from 'three';

const kinds = ['plane', 'cylinder', 'box', 'room'];

function readAddress() {
  const values = {};
  const text = location.hash.slice(1).replaceAll('%2C', ','); // as mail programs write commas
  for (const part of text.split('&')) {
    const [key, value = ''] = part.split('=');
    if (key)
      values[key] = value;
  }
  return values;
}

function writeAddress(values) {
  const text = Object.entries(values).filter(([, value]) => value !== null && value !== undefined && value !== '')
    .map(([key, value]) => `${key}=${value}`).join('&');
  if (location.hash.slice(1) === text)
    return;
  try {
    history.replaceState(null, '', `#${text}`);
  } catch {
    // some browsers refuse this for files: the page works without
  }
}

const numbersOf = text => (text ?? '').split(',').map(Number);

const isPlace = numbers => numbers.length === 3 && numbers.every(Number.isFinite);

// Camera, choice, measure and layers of a viewer become the address. Places are in the frame of
// the map.
export function writeLink({view, world, measuring, card, layers, occlusion}) {
  const place = vector => world.frame.placeInMap(vector).map(x => Number(x.toFixed(3))).join(',');
  const to = view.controls.getTarget(new Vector3(), true), at = view.controls.getPosition(new Vector3(), true);
  if (view.name === 'inside') // whose target is at the eye
    to.sub(at).normalize().multiplyScalar(2).add(at);
  writeAddress({view: view.name, at: place(at), to: place(to),
                zoom: view.name === 'dollhouse' ? null : Number(view.camera.zoom.toFixed(3)),
                [card.item?.kind]: card.item?.id,
                [measuring.between]: measuring.link(),
                layers: layers.switched().join(','), ao: occlusion.is_on ? null : 0});
}

function standAs(viewer, at, to, zoom) {
  const {view, world} = viewer;
  const [eye, target] = [at, to].map(place => world.frame.place(place));
  if (view.name === 'inside')
    view.stand(eye, target.sub(eye), false);
  else
    view.controls.setLookAt(...eye, ...target, false);
  if (zoom > 0 && view.name !== 'dollhouse')
    view.controls.zoomTo(zoom, false);
}

// Shows what the address says.
export function followLink(viewer) {
  const link = readAddress();
  viewer.occlusion.is_on = link.ao !== '0';
  if (link.layers !== undefined)
    viewer.layers.switchTo(link.layers.split(','));
  viewer.enter(Object.keys(viewer.views).includes(link.view) ? link.view : viewer.view?.name ?? 'dollhouse');
  const at = numbersOf(link.at), to = numbersOf(link.to);
  const has_camera = isPlace(at) && isPlace(to);
  if (has_camera)
    standAs(viewer, at, to, Number(link.zoom));
  for (const between of ['points', 'planes'])
    if (link[between])
      viewer.measuring.follow(between, numbersOf(link[between]));
  const kind = kinds.find(name => link[name] !== undefined);
  const item = kind && viewer.world.items.find(kind, Number(link[kind]));
  if (item) {
    viewer.reveal(item);
    viewer.choose(item);
    if (!has_camera)
      viewer.view.show(item);
  } else if (kind || !viewer.card.item || has_camera) {
    viewer.choose(null);
  }
}
