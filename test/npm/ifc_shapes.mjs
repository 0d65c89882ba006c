// Usage: node ifc_shapes.mjs MODEL.ifc SHAPES.obj
// Triangulates the products of a building model with web-ifc, and its openings and spaces, which it
// leaves out otherwise, as OBJ: metres, y up, an object for each product, named by its number, its
// type and, for an opening, the type of what fills it.
import {readFileSync, writeFileSync} from 'node:fs';
import * as ifc from 'web-ifc';

const [model_path, shapes_path] = process.argv.slice(2);
if (!shapes_path) {
  console.error('usage: node ifc_shapes.mjs MODEL.ifc SHAPES.obj');
  process.exit(2);
}
const api = new ifc.IfcAPI();
await api.Init();
api.SetLogLevel(ifc.LogLevel.LOG_LEVEL_ERROR);
const model = api.OpenModel(new Uint8Array(readFileSync(model_path)));

const typeOf = id => api.GetNameFromTypeCode(api.GetLineType(model, id));
const fillings = new Map();
const fills = api.GetLineIDsWithType(model, ifc.IFCRELFILLSELEMENT);
for (let i = 0; i < fills.size(); ++i) {
  const line = api.GetLine(model, fills.get(i));
  fillings.set(line.RelatingOpeningElement.value, typeOf(line.RelatedBuildingElement.value));
}

const lines = [];
let vertices = 0;
function addMesh(mesh) {
  const filling = fillings.get(mesh.expressID);
  lines.push(`o ${mesh.expressID} ${typeOf(mesh.expressID)}${filling ? ' ' + filling : ''}`);
  for (let g = 0; g < mesh.geometries.size(); ++g) {
    const placed = mesh.geometries.get(g);
    const m = placed.flatTransformation;
    const geometry = api.GetGeometry(model, placed.geometryExpressID);
    const values = api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
    const indices = api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
    lines.push(placed.color.w < 1 ? 'usemtl glass' : 'usemtl opaque');
    for (let k = 0; k < values.length; k += 6) { // position and normal
      const at = row => m[row] * values[k] + m[4 + row] * values[k + 1] + m[8 + row] * values[k + 2] + m[12 + row];
      lines.push(`v ${at(0).toFixed(7)} ${at(1).toFixed(7)} ${at(2).toFixed(7)}`);
    }
    for (let k = 0; k < indices.length; k += 3)
      lines.push(`f ${indices[k] + vertices + 1} ${indices[k + 1] + vertices + 1} ${indices[k + 2] + vertices + 1}`);
    vertices += values.length / 6;
  }
}
api.StreamAllMeshes(model, addMesh);
api.StreamAllMeshesWithTypes(model, [ifc.IFCOPENINGELEMENT, ifc.IFCSPACE], addMesh);
writeFileSync(shapes_path, lines.join('\n') + '\n');
