// Reads the data and shows them. `reeb_graph_page` is there for scripts, once the first picture is.

import { read_data } from "./data.js";
import { Page } from "./Page.js";

async function start() {
  const message = document.getElementById("message");
  try {
    const data = await read_data(document.getElementById("data").textContent);
    window.reeb_graph_page = new Page(data);
    performance.mark("first picture");
    message.hidden = true;
  } catch (error) {
    message.textContent = `The picture cannot be shown: ${error.message}`;
    throw error;
  }
}

start();
