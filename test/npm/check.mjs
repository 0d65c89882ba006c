// Usage: node check.mjs MAP_DIR
// Opens map.glb with the validator of Khronos and map.ifc with web-ifc, and compares both with
// map.json. Ends with 1 if there is an error.
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import validator from 'gltf-validator';
import * as ifc from 'web-ifc';

const folder = process.argv[2];
if (!folder) {
  console.error('usage: node check.mjs MAP_DIR');
  process.exit(2);
}
let faults = 0;
function expect(isTrue, text) {
  console.log((isTrue ? 'ok      ' : 'FAILED  ') + text);
  faults += isTrue ? 0 : 1;
}

const map = JSON.parse(readFileSync(join(folder, 'map.json')));

const glb = await validator.validateBytes(new Uint8Array(readFileSync(join(folder, 'map.glb'))));
expect(glb.issues.numErrors === 0, `map.glb: ${glb.issues.numErrors} errors, ${glb.issues.numWarnings} warnings`);
for (const issue of glb.issues.messages)
  console.log('        ' + issue.code + ': ' + issue.message + ' ' + (issue.pointer || ''));

const api = new ifc.IfcAPI();
await api.Init();
api.SetLogLevel(ifc.LogLevel.LOG_LEVEL_WARN);
const model = api.OpenModel(new Uint8Array(readFileSync(join(folder, 'map.ifc'))));
expect(api.GetModelSchema(model) === 'IFC4', 'map.ifc: schema ' + api.GetModelSchema(model));

const count = type => api.GetLineIDsWithType(model, type).size();
const elements = [ifc.IFCWALL, ifc.IFCSLAB, ifc.IFCCOVERING, ifc.IFCBUILDINGELEMENTPROXY, ifc.IFCDOOR, ifc.IFCCOLUMN, ifc.IFCFURNITURE];
expect(count(ifc.IFCSPACE) === (map.rooms || []).length, `map.ifc: ${count(ifc.IFCSPACE)} spaces`);
expect(count(ifc.IFCOPENINGELEMENT) <= (map.openings || []).length, `map.ifc: ${count(ifc.IFCOPENINGELEMENT)} openings of ${(map.openings || []).length}`);
expect(count(ifc.IFCWALL) > 0, `map.ifc: ${count(ifc.IFCWALL)} walls, ${count(ifc.IFCSLAB)} slabs, ${count(ifc.IFCCOVERING)} ceilings, ` +
       `${count(ifc.IFCDOOR)} doors, ${count(ifc.IFCCOLUMN)} columns, ${count(ifc.IFCBUILDINGELEMENTPROXY)} proxies`);

// every identifier is there once
const guids = [];
const all = api.GetAllLines(model);
for (let i = 0; i < all.size(); ++i) {
  const line = api.GetLine(model, all.get(i));
  if (line && line.GlobalId)
    guids.push(line.GlobalId.value);
}
expect(new Set(guids).size === guids.length, `map.ifc: ${guids.length} identifiers, all different`);

// The axis of the map that is up: as stated, as the cameras stood, or either of those of a cloud.
const axisOf = v => {
  const k = v.map(Math.abs).indexOf(Math.max(...v.map(Math.abs)));
  return v.map((x, i) => i === k ? Math.sign(x) : 0);
};
const upOfCamera = ({orientation: [x, y, z, w]}) => [2 * (w * z - x * y), 2 * (x * x + z * z) - 1, -2 * (y * z + w * x)];
const cameras = (map.trajectory || []).map(upOfCamera).reduce((sum, v) => sum.map((x, i) => x + v[i]), [0, 0, 0]);
const ups = map.up ? [axisOf(map.up)] : map.trajectory?.length ? [axisOf(cameras)] : [[0, -1, 0], [0, 0, 1]];
const turnTo = {
  0: sign => p => [-sign * p[1], -p[2], sign * p[0]],
  1: sign => p => [p[0], -sign * p[2], sign * p[1]],
  2: sign => p => [p[0], sign * p[1], sign * p[2]],
};
const turns = ups.map(up => { const k = up.findIndex(x => x !== 0); return turnTo[k](up[k]); });

// the corners of each wall are those of its plane
let walls = 0, meshes = 0;
const farthest = turns.map(() => 0);
const near = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const ids = api.GetLineIDsWithType(model, ifc.IFCWALL);
for (let i = 0; i < ids.size(); ++i) {
  const wall = api.GetLine(model, ids.get(i), true);
  const plane = map.planes[Number(wall.Tag.value.replace('Plane ', ''))];
  const corners = plane.polygons.flatMap(p => [p.outer, ...(p.holes || [])]).flat();
  const list = wall.Representation.Representations[0].Items[0].Coordinates.CoordList.map(row => row.map(x => x.value));
  turns.forEach((turn, t) => list.forEach((p, k) => { farthest[t] = Math.max(farthest[t], near(p, turn(corners[k]))); }));
  ++walls;
}
const off = Math.min(...farthest);
expect(off < 0.001, `map.ifc: corners of ${walls} walls within ${(1000 * off).toFixed(6)} mm of map.json`);
api.StreamAllMeshes(model, mesh => { meshes += mesh.geometries.size(); });
const shaped = elements.reduce((sum, type) => sum + count(type), 0);
expect(meshes >= shaped, `map.ifc: ${meshes} meshes of ${shaped} elements`);
process.exit(faults > 0 ? 1 : 0);
