// Rooms and surfaces as a list that can be searched.

import {squareMetres} from './names.js';

// [title, items] in the order in which they are listed.
function groupsOf(items, fragments) {
  const listed = new Set();
  const groups = [];
  for (const room of items.rooms) {
    const planes = room.planes.map(id => items.planes[id]).filter(item => item);
    planes.forEach(item => listed.add(item));
    groups.push({room, items: planes});
  }
  const rest = items.planes.filter(item => !listed.has(item));
  const add = (title, list) => list.length > 0 && groups.push({title, items: list});
  add(items.rooms.length > 0 ? 'Other surfaces' : 'Surfaces', rest.filter(item => !fragments.has(item.id)));
  add('Cylinders', items.cylinders);
  add('Boxes', items.boxes);
  add('Fragments', rest.filter(item => fragments.has(item.id)));
  return groups;
}

export class List {
  constructor(items, fragments, chosen) {
    this.groups = groupsOf(items, fragments);
    for (const group of this.groups)
      group.items.sort((a, b) => b.area - a.area);
    this.chosen = chosen;
    this.buttons = new Map();
    this.place = document.getElementById('list');
    this.search = document.getElementById('search');
    this.search.addEventListener('input', () => this.fill());
    this.fill();
  }

  button(item, is_room) {
    const button = document.createElement('button');
    button.className = is_room ? 'room' : '';
    button.dataset.item = `${item.kind}=${item.id}`;
    const name = document.createElement('span'), area = document.createElement('span');
    name.textContent = item.name;
    area.textContent = item.area > 0 ? squareMetres(item.area) : '';
    button.append(name, area);
    button.addEventListener('click', () => this.chosen(item));
    this.buttons.set(item, [...(this.buttons.get(item) ?? []), button]);
    return button;
  }

  fill() {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(word => word);
    const matches = item => words.every(word =>
      `${item.name} ${item.role} ${item.kind} ${item.id} ${item.openings.join(' ')}`.toLowerCase().includes(word));
    this.buttons.clear();
    this.place.replaceChildren();
    for (const {room, title, items} of this.groups) {
      const found = items.filter(matches);
      if (room && (found.length > 0 || matches(room)))
        this.place.append(this.button(room, true));
      else if (found.length > 0)
        this.place.append(Object.assign(document.createElement('h3'), {textContent: title}));
      this.place.append(...found.map(item => this.button(item, false)));
    }
    if (this.place.children.length === 0)
      this.place.append(Object.assign(document.createElement('p'), {textContent: 'Nothing has this name.'}));
    this.mark(this.marked);
  }

  mark(item) {
    for (const [other, buttons] of this.buttons)
      for (const button of buttons)
        button.setAttribute('aria-current', String(other === item));
    if (item && item !== this.marked)
      this.buttons.get(item)?.[0].scrollIntoView({block: 'nearest'});
    this.marked = item;
  }
}
