/**
 * Serves the built page to the journeys, as scripts/serve.mjs does, but uncompressed: compressing the site takes as much
 * time as two journeys, and tests/serving.test.ts looks at that. `node e2e/serve.mjs 4179` listens on that port.
 */
import { createServer } from "node:http";
import { site } from "../scripts/serve.mjs";

const answer = site(new URL("../dist", import.meta.url).pathname);
createServer((request, response) => {
  delete request.headers["accept-encoding"];
  void answer(request, response).catch(() => response.destroy());
}).listen(Number(process.argv[2]), "127.0.0.1");
