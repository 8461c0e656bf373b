import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { FinishedPart } from "../../src/planning/part/finished-part.ts";
import { readPart } from "../../src/planning/part/part-file.ts";

/** From the project folder: the script that prints tables is bundled elsewhere. */
const FOLDER = join("tests", "planning");

const namesIn = (folder: string): readonly string[] =>
  readdirSync(join(FOLDER, folder))
    .filter((name) => name.endsWith(".json"))
    .map((name) => name.slice(0, -".json".length))
    .toSorted();

/** Names of the parts of the trade: files of `parts/`. */
export const PART_NAMES: readonly string[] = namesIn("parts");
/** Names of parts that programs for other controls state: files of `peers/`, whose sources docs/planning.md names. */
export const PEER_NAMES: readonly string[] = namesIn("peers");

/** The text of a part file. */
export const partText = (name: string): string =>
  readFileSync(join(FOLDER, PEER_NAMES.includes(name) ? "peers" : "parts", `${name}.json`), "utf8");

/** A part of the trade, or of another control. */
export function partOfTrade(name: string): FinishedPart {
  const { part, problems } = readPart(partText(name));
  if (!part) throw new Error(`${name}: ${JSON.stringify(problems)}`);
  return part;
}
