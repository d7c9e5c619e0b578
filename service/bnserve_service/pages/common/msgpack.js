// A reader of MessagePack, as much of it as this server writes, with its arrays as typed arrays.

const ARRAYS = { "<f8": Float64Array, "<f4": Float32Array, "<c16": Float64Array, "<c8": Float32Array, "|u1": Uint8Array };

/** Decode one message. Arrays are `{shape, data}`; of complex numbers real and imaginary parts take turns in `data`. */
export function decode(buffer) {
  const view = new DataView(buffer);
  const text = new TextDecoder();
  let at = 0;

  const take = (count) => (at += count) - count;
  const string = (length) => text.decode(new Uint8Array(buffer, take(length), length));
  const binary = (length) => new Uint8Array(buffer, take(length), length);
  const list = (length) => Array.from({ length }, value);

  function map(length) {
    const found = {};
    for (let i = 0; i < length; i++) {
      const key = value();
      found[key] = value();
    }
    return found.nd === true ? asArray(found) : found;
  }

  const SIZED = {
    0xc4: () => binary(view.getUint8(take(1))), 0xc5: () => binary(view.getUint16(take(2))),
    0xc6: () => binary(view.getUint32(take(4))), 0xca: () => view.getFloat32(take(4)),
    0xcb: () => view.getFloat64(take(8)), 0xcc: () => view.getUint8(take(1)), 0xcd: () => view.getUint16(take(2)),
    0xce: () => view.getUint32(take(4)), 0xcf: () => Number(view.getBigUint64(take(8))),
    0xd0: () => view.getInt8(take(1)), 0xd1: () => view.getInt16(take(2)), 0xd2: () => view.getInt32(take(4)),
    0xd3: () => Number(view.getBigInt64(take(8))), 0xd9: () => string(view.getUint8(take(1))),
    0xda: () => string(view.getUint16(take(2))), 0xdb: () => string(view.getUint32(take(4))),
    0xdc: () => list(view.getUint16(take(2))), 0xdd: () => list(view.getUint32(take(4))),
    0xde: () => map(view.getUint16(take(2))), 0xdf: () => map(view.getUint32(take(4))),
    0xc0: () => null, 0xc2: () => false, 0xc3: () => true,
  };

  function value() {
    const code = view.getUint8(take(1));
    if (code < 0x80) return code;
    if (code >= 0xe0) return code - 0x100;
    if (code < 0x90) return map(code & 0x0f);
    if (code < 0xa0) return list(code & 0x0f);
    if (code < 0xc0) return string(code & 0x1f);
    if (!SIZED[code]) throw new Error("The answer is not MessagePack as this page reads it.");
    return SIZED[code]();
  }

  return value();
}

function asArray({ type, shape, data }) {
  const Kind = ARRAYS[type];
  if (!Kind) throw new Error(`The answer has an array of type ${type}, which this page does not read.`);
  const aligned = data.byteOffset % Kind.BYTES_PER_ELEMENT === 0 ? data : data.slice();
  return { shape, data: new Kind(aligned.buffer, aligned.byteOffset, aligned.byteLength / Kind.BYTES_PER_ELEMENT) };
}
