import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { catalogue } from "../src/cycles/index.ts";
import { cycleSvg } from "./cycle-picture.ts";
import { cyclePage } from "./cycle-page.ts";

/** `npm run docs`: writes the page of every cycle, and its picture beside it. Runs in the project folder. */
export function main(): number {
  const folder = join("docs", "cycles");
  mkdirSync(folder, { recursive: true });
  for (const cycle of catalogue) {
    writeFileSync(join(folder, `${cycle.number}.md`), cyclePage(cycle));
    console.log(join(folder, `${cycle.number}.md`));
    const picture = cycleSvg(cycle);
    if (picture) writeFileSync(join(folder, `${cycle.number}.svg`), picture);
  }
  return 0;
}
