import type { Program } from "../../nc/program.ts";

/** A program that was opened with the main program. */
export interface ProgramFile {
  readonly name: string;
  readonly program: Program;
}

/** The programs that a run can call. */
export interface ProgramFiles {
  /** The program of a name as `fileKey` makes it; null when there is none. */
  find(key: string): ProgramFile | null;
}

/** Comparison key of a file name: without folder and case; a name without extension is that of a program. */
export function fileKey(name: string): string {
  const bare = name
    .trim()
    .replace(/^.*[\\/:]/, "")
    .toUpperCase();
  return bare === "" || bare.includes(".") ? bare : `${bare}.H`;
}

/** Program name in the second line of cycle 12: `PGM TNC:\DRILL.H`, or the name alone. */
export const nameInCycle = (text: string): string =>
  text
    .replace(/^PGM[ \t]+/i, "")
    .replaceAll('"', "")
    .trim();

/** Files by their names, each read when it is first called. Of two with one name the first counts. */
export function filesByName(
  files: readonly { readonly name: string; readonly text: string }[],
  parse: (text: string) => Program,
): ProgramFiles {
  const texts = new Map(files.toReversed().map((file) => [fileKey(file.name), file]));
  const read = new Map<string, ProgramFile>();
  return {
    find: (key) => {
      const known = read.get(key);
      const file = texts.get(key);
      if (known || !file) return known ?? null;
      const made = { name: file.name, program: parse(file.text) };
      read.set(key, made);
      return made;
    },
  };
}
