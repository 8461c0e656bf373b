import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { FinishedPart } from "../../src/planning/part/finished-part.ts";
import { readPart } from "../../src/planning/part/part-file.ts";

/** From the project folder: the script that prints tables is bundled elsewhere. */
const FOLDER = join("tests", "planning", "parts");

/** Names of the parts of the trade: files of `parts/`. */
export const PART_NAMES: readonly string[] = readdirSync(FOLDER)
  .filter((name) => name.endsWith(".json"))
  .map((name) => name.slice(0, -".json".length))
  .toSorted();

/** The text of a part file. */
export const partText = (name: string): string => readFileSync(join(FOLDER, `${name}.json`), "utf8");

/** A part of the trade. */
export function partOfTrade(name: string): FinishedPart {
  const { part, problems } = readPart(partText(name));
  if (!part) throw new Error(`${name}: ${JSON.stringify(problems)}`);
  return part;
}
