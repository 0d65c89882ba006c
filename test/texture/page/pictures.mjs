// What a picture of a page shows, found by the browser itself, which can decode it.

const background = [233, 238, 243];

async function inBrowser(browser, png, text) {
  const page = await browser.open('about:blank');
  const found = await page.value(`(async () => {
    const image = await createImageBitmap(await (await fetch('data:image/png;base64,${png}')).blob());
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const {data, width, height} = context.getImageData(0, 0, image.width, image.height);
    ${text}
  })()`);
  await page.close();
  return found;
}

// Of all colours but white and the background.
export function commonestColour(browser, png) {
  return inBrowser(browser, png, `
    const counts = new Map();
    for (let i = 0; i < data.length; i += 4) {
      const key = data[i] << 16 | data[i + 1] << 8 | data[i + 2];
      counts.set(key, (counts.get(key) ?? 0) + 1);
    }
    for (const [r, g, b] of [[255, 255, 255], [${background}]])
      counts.delete(r << 16 | g << 8 | b);
    const best = [...counts].reduce((a, b) => b[1] > a[1] ? b : a, [0, 0])[0];
    return [best >> 16, best >> 8 & 255, best & 255];`);
}

// Colours that a share of the picture has.
export function frequentColours(browser, png, share) {
  return inBrowser(browser, png, `
    const counts = new Map();
    for (let i = 0; i < data.length; i += 4) {
      const key = data[i] << 16 | data[i + 1] << 8 | data[i + 2];
      counts.set(key, (counts.get(key) ?? 0) + 1);
    }
    return [...counts].filter(([, count]) => count > ${share} * width * height)
      .map(([key]) => [key >> 16, key >> 8 & 255, key & 255]);`);
}

// How many of the pixels are darker than 0.9 times a level of red.
export function shareDarkerThan(browser, png, red) {
  return inBrowser(browser, png, `
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      count += data[i] < ${0.9 * red} && data[i] > ${0.3 * red} ? 1 : 0;
    return count / (width * height);`);
}

// The part of the window, in its pixels, that differs from the background.
export function boundsOfChange(browser, png, size) {
  return inBrowser(browser, png, `
    const ratio = width / ${size.width};
    const isDrawn = (x, y) => {
      const i = 4 * (y * width + x);
      return [${background}].some((level, k) => Math.abs(data[i + k] - level) > 20);
    };
    const rows = new Array(height).fill(0), columns = new Array(width).fill(0);
    for (let y = 0; y < height; ++y)
      for (let x = 0; x < width; ++x)
        if (isDrawn(x, y))
          ++rows[y], ++columns[x];
    const first = list => list.findIndex(count => count > 0);
    const last = list => list.findLastIndex(count => count > 0) + 1;
    return {left: first(columns) / ratio, right: last(columns) / ratio, top: first(rows) / ratio, bottom: last(rows) / ratio};`);
}
