import { cpSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { keptFiles } from "../../scripts/offline.ts";
import { site } from "../../scripts/serve.mjs";

const BUILT = new URL("../../dist", import.meta.url).pathname;
const UNDER = "/shop/turnwise/";
/** What may be a file's name: one pattern of all the names would take a quarter of a minute. */
const FILE_NAME = /[\w$-]+\.\w+/g;

/**
 * Copies the built site as another version: renames every hashed file and all references to it, and updates the list of
 * the service worker. Returns its folder.
 */
export function newerVersion(): string {
  const folder = mkdtempSync(join(tmpdir(), "turnwise-newer-"));
  cpSync(BUILT, folder, { recursive: true });
  const assets = readdirSync(join(folder, "assets"));
  const renamed = new Map(assets.map((name) => [name, name.replace(/(\.\w+)$/, "x$1")]));
  const rewrite = (path: string) =>
    writeFileSync(
      path,
      readFileSync(path, "utf8").replaceAll(FILE_NAME, (name) => renamed.get(name) ?? name),
    );
  for (const [name, fresh] of renamed) {
    if (/\.(?:js|css)$/.test(name)) rewrite(join(folder, "assets", name));
    renameSync(join(folder, "assets", name), join(folder, "assets", fresh));
  }
  rewrite(join(folder, "index.html"));
  const worker = join(folder, "sw.js");
  const list = JSON.stringify(keptFiles(folder));
  writeFileSync(
    worker,
    readFileSync(worker, "utf8").replace(/\[\{url:`[\s\S]*?\}\]/, () => list),
  );
  return folder;
}

/** A server for the built site below a path, which can be told to fail in the ways servers do. */
export class Site {
  private folder = BUILT;
  private fails: (path: string) => boolean = () => false;
  /** Requested paths, without the folder of the site. */
  readonly asked: string[] = [];

  private constructor(private readonly server: Server) {}

  static async start(): Promise<Site> {
    const server = createServer();
    const made = new Site(server);
    server.on("request", (request, response) => {
      const path = (request.url ?? "").slice(UNDER.length);
      made.asked.push(path);
      if (made.fails(path)) return response.destroy();
      // Compressing the whole site takes longer than storing it: tests/serving.test.ts looks at that.
      delete request.headers["accept-encoding"];
      return void site(made.folder, UNDER)(request, response).catch(() => response.destroy());
    });
    await new Promise<void>((done) => server.listen(0, "127.0.0.1", done));
    return made;
  }

  get url(): string {
    return `http://127.0.0.1:${(this.server.address() as AddressInfo).port}${UNDER}`;
  }

  /** Serves this folder from now on; the connection breaks on the listed paths. */
  serve(folder: string, fails: (path: string) => boolean = () => false): void {
    this.folder = folder;
    this.fails = fails;
  }

  stop(): void {
    this.server.close();
    this.server.closeAllConnections();
    if (this.folder !== BUILT) rmSync(this.folder, { recursive: true });
  }
}
