// Usage: node check_bag.mjs BAG.mcap
// Reads a bag of write_test_bag with the library of MCAP, which compares checksums and lengths.
// Ends with 1 if there is an error.
import {readFileSync} from 'node:fs';
import {McapStreamReader} from '@mcap/core';
import {decompress as unpackZstd} from 'fzstd';
import lz4 from 'lz4js';

const path = process.argv[2];
if (!path) {
  console.error('usage: node check_bag.mjs BAG.mcap');
  process.exit(2);
}
const reader = new McapStreamReader({
  validateCrcs: true,
  decompressHandlers: {
    zstd: (bytes, size) => unpackZstd(bytes, new Uint8Array(Number(size))),
    lz4: (bytes, size) => lz4.decompress(bytes, Number(size)),
  },
});
reader.append(new Uint8Array(readFileSync(path)));
const channels = new Map(), schemas = new Map(), counts = new Map();
let last = '';
for (let record; (record = reader.nextRecord());) {
  last = record.type;
  if (record.type === 'Schema')
    schemas.set(record.id, record.name);
  if (record.type === 'Channel')
    channels.set(record.id, record);
  if (record.type === 'Message')
    counts.set(record.channelId, (counts.get(record.channelId) || 0) + 1);
}
for (const [id, count] of counts)
  console.log(`ok      ${channels.get(id).topic}: ${count} of ${schemas.get(channels.get(id).schemaId)}`);
const isWhole = reader.done() && last === 'Footer' && counts.size > 0;
console.log(isWhole ? 'ok      read to its end' : 'FAILED  not read to its end');
process.exit(isWhole ? 0 : 1);
