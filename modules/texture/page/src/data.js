// What the page holds beside its script: map.json, the way before the rectification, map.glb
// and the kinds of the texels.

const textOf = id => document.getElementById(id)?.textContent ?? '';

function parsed(id, what) {
  try {
    return JSON.parse(textOf(id));
  } catch (error) {
    throw new Error(`${what} in this page is damaged: ${error.message}`);
  }
}

function bytesOfBase64(text) {
  try {
    if (Uint8Array.fromBase64)
      return Uint8Array.fromBase64(text);
    const characters = atob(text);
    const bytes = new Uint8Array(characters.length);
    for (let i = 0; i < bytes.length; ++i)
      bytes[i] = characters.charCodeAt(i);
    return bytes;
  } catch {
    throw new Error('the surfaces in this page are damaged: they are not base64');
  }
}

// {map, before: positions, has_colours: has anybody seen one?, glb: bytes, kinds: {name: bytes}, previews: {name of a page:
// {size, jpeg: bytes}}}
export function readData() {
  const map = parsed('map_json', 'map.json');
  if (!map || !Array.isArray(map.planes))
    throw new Error('map.json in this page has no list of planes');
  const kinds = {};
  for (const [name, text] of Object.entries(parsed('kinds_json', 'the list of texels')))
    kinds[name] = bytesOfBase64(text);
  const previews = parsed('previews_json', 'the list of small pictures');
  for (const preview of Object.values(previews))
    preview.jpeg = bytesOfBase64(preview.jpeg);
  return {map, kinds, previews, before: parsed('before_json', 'the way before'),
          has_colours: document.body.dataset.colours !== 'none', glb: bytesOfBase64(textOf('map_glb'))};
}
