// Texts at places of the scene.

export class Labels {
  constructor() {
    this.place = document.getElementById('labels');
    this.groups = new Map();
  }

  // entries: {place, text, isShown}
  set(group, entries) {
    for (const {element} of this.groups.get(group) ?? [])
      element.remove();
    this.groups.set(group, entries.map(entry => {
      const element = document.createElement('div');
      element.className = group;
      element.textContent = entry.text;
      this.place.append(element);
      return {...entry, element};
    }));
  }

  follow(camera) {
    for (const entry of [...this.groups.values()].flat()) {
      const at = entry.place.clone().project(camera);
      const is_shown = at.z > -1 && at.z < 1 && (entry.isShown?.() ?? true);
      entry.element.style.display = is_shown ? '' : 'none';
      entry.element.style.left = `${(at.x + 1) * 50}%`;
      entry.element.style.top = `${(1 - at.y) * 50}%`;
    }
  }
}
