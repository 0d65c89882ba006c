// Where the kind of a texel stands: charts have their texels in a page of colours, perhaps
// halved, and their kinds at another place in another page.

// The charts and unrolled cylinders of the map, by the page of their colours.
export function picturesOf(map) {
  const pictures = [];
  for (const plane of map.planes)
    pictures.push(...(plane.charts ?? []));
  for (const cylinder of map.cylinders ?? [])
    if (cylinder.texture)
      pictures.push(cylinder.texture);
  return pictures.filter(picture => picture.image && picture.at).map(picture => {
    const scale = 2 ** (picture.halvings ?? 0);
    return {...picture, columns: Math.ceil(picture.width / scale), rows: Math.ceil(picture.height / scale)};
  });
}

export class KindPlaces {
  // page: {image name, width, height}
  constructor(pictures, page) {
    this.page = page;
    this.pictures = pictures.filter(picture => picture.image === page.name);
    this.last = null;
  }

  // The picture that holds a place of the page, in texels.
  pictureAt(x, y) {
    const holds = p => x >= p.at[0] && y >= p.at[1] && x <= p.at[0] + p.columns && y <= p.at[1] + p.rows;
    if (!this.last || !holds(this.last))
      this.last = this.pictures.find(holds) ?? null;
    return this.last;
  }

  // Coordinates in the page of kinds for three corners of a triangle, whose texture
  // coordinates are u, v; negative if all its texels were seen.
  of(corners, sizeOf) {
    const width = this.page.width, height = this.page.height;
    const x = (corners[0] + corners[2] + corners[4]) / 3 * width;
    const y = (corners[1] + corners[3] + corners[5]) / 3 * height;
    const picture = this.pictureAt(x, y);
    const size = picture?.kinds && sizeOf(picture.kinds);
    if (!size)
      return {name: null, coordinates: [-1, -1, -1, -1, -1, -1], has_picture: Boolean(picture)};
    const [left, top] = picture.kinds_at ?? [0, 0];
    const coordinates = [];
    for (let i = 0; i < 6; i += 2) {
      const column = (corners[i] * width - picture.at[0]) / picture.columns * picture.width;
      const row = (corners[i + 1] * height - picture.at[1]) / picture.rows * picture.height;
      coordinates.push((left + column) / size[0], (top + row) / size[1]);
    }
    return {name: picture.kinds, coordinates, has_picture: true};
  }
}
