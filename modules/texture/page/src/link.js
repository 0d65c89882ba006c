// The link of what is shown: the part of the page's address behind #.

export function readLink() {
  const values = {};
  for (const part of location.hash.slice(1).split('&')) {
    const [key, value = ''] = part.split('=');
    if (key)
      values[key] = decodeURIComponent(value);
  }
  return values;
}

export const numbersOf = text => (text ?? '').split(',').map(Number);

export const isPlace = numbers => numbers.length === 3 && numbers.every(Number.isFinite);

export function writeLink(values) {
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
