import { fileKey } from "../../program/state/program-files.ts";
import type { RunFinding } from "../../program/state/run-types.ts";
import type { Outcome } from "./outcome.ts";
import { fileOf, type ProgramWork } from "../document/work.ts";

/** A file name without its folder. */
const bare = (name: string): string => name.trim().replace(/^.*[\\/:]/, "");

/** The called file that a finding reports as missing, by its name without folder; null for other findings. */
export function missingFile({ issue }: Pick<RunFinding, "issue">): string | null {
  if (issue.code !== "programNotOpened" && issue.code !== "contourInFile") return null;
  const name = bare(issue.data.file);
  return name.includes(".") ? name : `${name}.H`;
}

/** The files that a program calls and that were not opened with it, each once, by their names without folder. */
export function missingFiles(program: ProgramWork, newest: Outcome | null): readonly string[] {
  const names = (newest?.run.issues ?? []).flatMap((found) => missingFile(found) ?? []);
  const missing = new Map(names.map((name) => [fileKey(name), name]));
  return [...missing].flatMap(([key, name]) => (fileOf(program, key) ? [] : [name]));
}
