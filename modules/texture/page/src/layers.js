// Which layers are shown; a layer that the map lacks has no box.

const boxes = [
  ['surfaces', 'surfaces', true, () => true],
  ['details', 'details', true, world => world.details],
  ['fragments', 'fragments that touch nothing', false, world => world.fragments.size > 0],
  ['unseen', 'unseen parts, hatched', true, world => world.has_unseen],
  ['behind', 'faces from behind', false, () => true],
  ['outlines', 'outlines', false, world => world.items.planes.length > 0],
  ['names', 'names of rooms', true, world => world.items.rooms.length > 0],
  ['way', 'way of the camera', false, world => world.way],
  ['before', 'way before the rectification', false, world => world.before]
];

export class Layers {
  constructor(world, changed) {
    this.changed = changed;
    this.box = {};
    const place = document.querySelector('#layers > div');
    for (const [name, text, is_on, isThere] of boxes) {
      this[name] = is_on && Boolean(isThere(world));
      if (!isThere(world))
        continue;
      const label = document.createElement('label');
      const box = this.box[name] = Object.assign(document.createElement('input'), {type: 'checkbox', checked: is_on});
      box.dataset.layer = name;
      box.addEventListener('change', () => this.set(name, box.checked));
      label.append(box, name === 'fragments' ? `${text} (${world.fragments.size})` : text);
      place.append(label);
    }
    showLegend(world);
  }

  set(name, is_on) {
    if (!this.box[name] || this[name] === is_on)
      return;
    this[name] = this.box[name].checked = is_on;
    this.changed();
  }

  // Names of those that are not as they were at first.
  switched() {
    return boxes.filter(([name, , is_on]) => this.box[name] && this[name] !== is_on).map(([name]) => name);
  }

  // Sets all as at first, but for those.
  switchTo(names) {
    for (const [name, , is_on] of boxes)
      this.set(name, names.includes(name) ? !is_on : is_on);
  }
}

function showLegend(world) {
  const legend = document.getElementById('legend');
  const add = (kind, text) => {
    const row = document.createElement('div');
    const sample = document.createElement('i');
    sample.className = kind;
    row.append(sample, text);
    legend.append(row);
  };
  if (world.surfaces.some(surface => surface.is_unseen))
    add('unseen', 'no camera saw its colour');
  if (!world.has_colours)
    add('plain', 'seen without colours');
  if (world.proposed)
    add('proposed', 'not seen, but must be there');
}
