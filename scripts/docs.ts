import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { catalogue } from "../src/cycles/index.ts";
import { cycleSvg } from "./cycle-picture.ts";
import { cyclePage } from "./cycle-page.ts";
import { isoPage } from "./iso-page.ts";
import { klartextPage } from "./klartext-page.ts";
import { machineJsonSchema, partJsonSchema } from "./json-schemas.ts";

/**
 * `npm run docs`: writes the page of every cycle with its picture, the page of all blocks, the page of DIN/ISO and the
 * schemas of machine and part files. Runs in the project folder.
 */
export function main(): number {
  const folder = join("docs", "cycles");
  mkdirSync(folder, { recursive: true });
  for (const cycle of catalogue) {
    writeFileSync(join(folder, `${cycle.number}.md`), cyclePage(cycle));
    console.log(join(folder, `${cycle.number}.md`));
    const picture = cycleSvg(cycle);
    if (picture) writeFileSync(join(folder, `${cycle.number}.svg`), picture);
  }
  writeFileSync(join("docs", "klartext.md"), klartextPage());
  writeFileSync(join("docs", "din-iso.md"), isoPage());
  writeFileSync(join("docs", "machine.schema.json"), machineJsonSchema());
  writeFileSync(join("docs", "part.schema.json"), partJsonSchema());
  return 0;
}
