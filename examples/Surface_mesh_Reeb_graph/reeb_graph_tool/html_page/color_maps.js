// Colors of values from 0 to 1, and of the types of nodes.

// From red through yellow, green and cyan to blue, as in the tool's PLY file.
function red_to_blue(t) {
  const hue = 4 * t;
  return [0, 2, 4].map((center) => Math.min(Math.max(2 - Math.abs(hue - center), 0), 1));
}

// Some colors of viridis (Smith and van der Walt, CC0), which people who confuse colors can read, and
// which becomes lighter all the way.
const viridis_colors = [
  0x440154, 0x482878, 0x3e4a89, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b,
  0xfde725,
].map((color) => [16, 8, 0].map((shift) => ((color >> shift) & 255) / 255));

function viridis(t) {
  const position = t * (viridis_colors.length - 1);
  const i = Math.min(Math.floor(position), viridis_colors.length - 2);
  return viridis_colors[i].map((x, c) => x + (position - i) * (viridis_colors[i + 1][c] - x));
}

export const color_maps = {
  "red to blue": red_to_blue,
  viridis,
  plain: () => [0.72, 0.74, 0.78],
};

// Bytes red, green, blue, alpha.
export function color_table(color_map, length = 256) {
  const table = new Uint8Array(4 * length);
  for (let i = 0; i < length; ++i)
    table.set([...color_map(i / (length - 1)).map((x) => Math.round(255 * x)), 255], 4 * i);
  return table;
}

// Types differ in their shapes, too. (Colors of Okabe and Ito.)
export const node_types = ["minimum", "maximum", "split", "merge", "isolated", "degenerate"];
export const node_colors = {
  minimum: "#0072b2",
  maximum: "#d55e00",
  split: "#e69f00",
  merge: "#56b4e9",
  isolated: "#999999",
  degenerate: "#cc79a7",
};
