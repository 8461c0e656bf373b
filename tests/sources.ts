import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, posix, sep } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");

/** An import or re-export: its target, and whether it imports only types. */
export interface Import {
  /** Path from the project folder for a relative import, the package name otherwise. */
  readonly target: string;
  readonly relative: boolean;
  readonly typesOnly: boolean;
  /** Loaded on demand, not with the file. */
  readonly lazy: boolean;
}
/** One source file, by its path from the project folder. */
export interface Source {
  readonly path: string;
  readonly text: string;
  readonly imports: readonly Import[];
}

const STATEMENT = new RegExp(
  String.raw`(?:^|\n)\s*(?:import|export)\s+(type\s+)?(?:([^"';]*?)\s*from\s*)?["']([^"']+)["']|` +
    String.raw`\bimport\(\s*["']([^"']+)["']\s*\)|new URL\(\s*["'](\.[^"']+)["']`,
  "g",
);

/** True when every name between the braces is marked `type`. */
const onlyTypes = (names: string | undefined) =>
  names !== undefined &&
  /^\{[^}]*\}$/.test(names.trim()) &&
  names
    .replace(/[{}\s]+/g, " ")
    .trim()
    .replace(/,\s*$/, "")
    .split(",")
    .every((n) => n.trim().startsWith("type "));

function imports(path: string, text: string): Import[] {
  return [...text.matchAll(STATEMENT)].map(([, type, names, fixed, lazy, url]) => {
    const to = fixed ?? lazy ?? url ?? "";
    const relative = to.startsWith(".");
    const target = relative
      ? posix.join(posix.dirname(path), to)
      : to
          .split("/")
          .slice(0, to.startsWith("@") ? 2 : 1)
          .join("/");
    return { target, relative, typesOnly: type !== undefined || onlyTypes(names), lazy: fixed === undefined };
  });
}

/** All TypeScript files below `folder`, without tests and their fixtures. */
export function sources(folder: string): Source[] {
  return readdirSync(join(root, folder), { recursive: true, withFileTypes: true })
    .filter((e) => e.isFile() && /\.tsx?$/.test(e.name) && !/\.test(-d)?\.tsx?$/.test(e.name))
    .map((e) =>
      join(e.parentPath, e.name)
        .slice(root.length + 1)
        .split(sep)
        .join("/"),
    )
    .sort()
    .map((path) => {
      const text = readFileSync(join(root, path), "utf8");
      return { path, text, imports: imports(path, text) };
    });
}

/** Text without comments. */
export const code = (text: string) => text.replace(/\/\*[\s\S]*?\*\//g, "").replace(/(^|[^:"'`])\/\/.*$/gm, "$1");

/** A file by its path from the project folder, as text. */
export const projectFile = (path: string) => readFileSync(join(root, path), "utf8");
/** Names of the files in a folder of the project. */
export const projectFolder = (path: string) => readdirSync(join(root, path));
/** Where a path from the project folder is on the disk. */
export const projectPath = (path: string) => join(root, path);
