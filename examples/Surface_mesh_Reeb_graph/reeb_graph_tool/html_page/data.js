// Reads what the tool has put into the page: arrays of numbers, and a header that lists them.

const version_known = 1;

function bytes_of_base64(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Differences in groups of seven bits, the sign lowest.
function read_integers(bytes, { begin, length, stride }) {
  const numbers = new Uint32Array(length);
  let position = begin;
  for (let i = 0; i < length; ++i) {
    let difference = 0;
    let shift = 0;
    let byte;
    do {
      byte = bytes[position++];
      difference |= (byte & 0x7f) << shift;
      shift += 7;
    } while (byte & 0x80);
    numbers[i] = ((difference >>> 1) ^ -(difference & 1)) + (i < stride ? 0 : numbers[i - stride]);
  }
  return numbers;
}

function read_doubles(bytes, { begin, length }) {
  const view = new DataView(bytes.buffer, bytes.byteOffset + begin, 8 * length);
  return Float64Array.from({ length }, (_, i) => view.getFloat64(8 * i, true));
}

// Steps of the box as coordinates, in units in which the box has its center at 0 and a diagonal of 2.
function scaled_points(steps, header) {
  const lengths = header.box.map(([low, high]) => high - low);
  const unit = Math.hypot(...lengths) / 2 || 1;
  const points = new Float32Array(steps.length);
  for (let i = 0; i < points.length; ++i)
    points[i] = ((steps[i] / header.steps - 0.5) * lengths[i % 3]) / unit;
  return points;
}

export async function read_data(text) {
  const separator = text.indexOf(";");
  let bytes = bytes_of_base64(text.slice(separator + 1));
  if (text.slice(0, separator) === "deflate") bytes = await inflate(bytes);
  const header_length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + header_length)));
  if (header.version !== version_known)
    throw new Error(`the data have version ${header.version}, this page knows ${version_known}`);
  const data = { header };
  const rest = bytes.subarray(4 + header_length);
  for (const array of header.arrays)
    data[array.name] =
      array.stride === undefined ? read_doubles(rest, array) : read_integers(rest, array);
  for (const name of ["points", "node_places", "arc_points"])
    data[name] = scaled_points(data[name], header);
  return data;
}
