// Makes page.png, the picture of the HTML page of the tool in the manual:
//
//   node page_picture.mjs PAGE.html CHROMIUM
//
// The page is that of CGAL's camel, with --simplify 0.1.

import { writeFileSync } from "node:fs";

import { Headless_browser } from "../../test/Surface_mesh_Reeb_graph/Headless_browser.mjs";

const [page, chromium] = process.argv.slice(2);
const browser = await Headless_browser.start(chromium, { width: 1200, height: 760 });
await browser.open(page);
await browser.wait_for("window.reeb_graph_page !== undefined");
// the arc that ends at the muzzle, on the left
await browser.evaluate(`(() => {
  const { graph, view } = reeb_graph_page;
  const x = (node) => view.node_on_screen(node).x;
  const muzzle = graph.nodes.reduce((m, n) => (x(n) < x(m) ? n : m));
  reeb_graph_page.pick({ kind: "arc", id: graph.arcs_of_node.get(muzzle).down[0] });
})()`);
await browser.evaluate("new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)))");
writeFileSync(new URL("page.png", import.meta.url), await browser.screenshot());
await browser.stop();
