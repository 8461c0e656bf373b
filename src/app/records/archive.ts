import { strFromU8, strToU8, zipSync, type Zippable } from "fflate";
import { packedFiles, unpackedFile } from "../base/unpack.ts";
import { encode } from "../document/encoding.ts";
import { parse } from "../../nc/parse.ts";
import { isoProgramText } from "../../nc/iso/print-iso.ts";
import { fileOfJob, printedText } from "../document/printed.ts";
import { isProgram, textsOf, type Work, type WorkFile } from "../document/work.ts";
import { fingerprint } from "./difference.ts";
import { eachPart, PART_NAMES, PARTS, type PartName, type PartValues } from "./parts.ts";
import { readSave, SAVE_VERSION } from "./save-file.ts";

/*
 * A backup: works and other data of a device, as a zip. Only `turnwise.json` is read back; it has everything, including
 * drafts of other cycles. The folders next to it have the same for people and other programs.
 */

const FORMAT = "turnwise-archive/";
const EDITION = 1;
const MANIFEST = "turnwise.json";

/** A work in an archive: its name on the source device, and its last change, ms since 1970. */
export interface ArchivedWork {
  readonly work: string;
  readonly savedAt: number;
  readonly job: Work;
}

/** What an archive holds. */
export interface ArchiveContent extends PartValues {
  readonly works: readonly ArchivedWork[];
}

/** A read archive. Unreadable items are listed; the others are still used. */
export interface ReadArchive extends ArchiveContent {
  /** Names of works that are damaged, or that only a newer edition can read. */
  readonly unread: readonly string[];
  /** Damaged parts other than works. */
  readonly unreadParts: readonly PartName[];
}

/** Why a file is rejected: another kind, altered, larger than the limits, or from a newer edition. */
export type ArchiveProblem = "notAnArchive" | "damaged" | "tooLarge" | "newer";

/** Limits of unpacking: bytes packed and unpacked, entries of the zip, works. */
export interface ArchiveLimits {
  readonly packed: number;
  readonly unpacked: number;
  readonly entries: number;
  readonly works: number;
}
export const ARCHIVE_LIMITS: ArchiveLimits = {
  packed: 100_000_000,
  unpacked: 200_000_000,
  entries: 60_000,
  works: 20_000,
};

/** Content with a fingerprint that reveals changes. Content without one, written by hand, is accepted. */
interface Sealed {
  readonly print?: unknown;
  readonly content?: unknown;
}
const sealed = (content: unknown): Sealed => ({ print: fingerprint(content), content });
const isRecord = (raw: unknown): raw is Readonly<Record<string, unknown>> =>
  typeof raw === "object" && raw !== null && !Array.isArray(raw);

/** The sealed content; undefined if it was altered. */
function unsealed(raw: unknown): unknown {
  if (!isRecord(raw)) return undefined;
  const { print, content } = raw as Sealed;
  return print === undefined || print === fingerprint(content) ? content : undefined;
}

/** File names that some systems reject. */
const RESERVED = /^(?:CON|PRN|AUX|NUL|COM\d|LPT\d)(?:\.|$)/i;

/** A name as one part of a path, on every system. */
function pathPart(name: string): string {
  const plain = name
    // eslint-disable-next-line no-control-regex -- these are just what must not stand there
    .replace(/[\u0000-\u001f\\/:*?"<>|]/g, "_")
    .slice(0, 80)
    .replace(/^[. ]+|(?<![. ])[. ]+$/g, "");
  return plain === "" || RESERVED.test(plain) ? `_${plain}` : plain;
}

/** Makes names unique, ignoring case: the second `A` becomes `A (2)`. The extension stays at the end. */
function namer(): (name: string) => string {
  const taken = new Set<string>();
  return (name) => {
    const [, stem = "", ending = ""] = /^(.*?)(\.[^.]{0,8})?$/s.exec(pathPart(name)) ?? [];
    let made = stem + ending;
    for (let n = 2; taken.has(made.toUpperCase()); n++) made = `${stem} (${n})${ending}`;
    taken.add(made.toUpperCase());
    return made;
  };
}

/** The files of a work as a control reads them; none if a job cannot be printed. */
function readable(job: Work): readonly WorkFile[] {
  if (isProgram(job)) return textsOf(job);
  try {
    const text = printedText(job);
    return [
      { name: fileOfJob(job), text: job.layout === "iso" ? isoProgramText(parse(text)).text : text, encoding: "utf-8" },
    ];
  } catch {
    return [];
  }
}

/** Range of times in a zip, ms since 1970. */
const [EARLIEST, LATEST] = [Date.UTC(1980, 0, 2), Date.UTC(2099, 11, 30)];
const zipTime = (time: number): number => Math.min(Math.max(Number.isFinite(time) ? time : EARLIEST, EARLIEST), LATEST);

/** Packs works and other parts into one file. */
export function writeArchive({ works: all = [], ...given }: Partial<ArchiveContent>): Uint8Array<ArrayBuffer> {
  const mtime = zipTime(Math.max(EARLIEST, ...all.map(({ savedAt }) => savedAt)));
  const beside = PART_NAMES.flatMap((name) => {
    const part = PARTS[name],
      value: unknown = given[name] ?? null;
    return value === null || part.isEmpty(value) ? [] : [{ name, part, value }];
  });
  const manifest = {
    format: `${FORMAT}${EDITION}`,
    works: all.map(({ work, savedAt, job }) => ({
      work,
      name: job.name,
      ...sealed({ version: SAVE_VERSION, savedAt, job }),
    })),
    ...Object.fromEntries(beside.map(({ name, part, value }) => [name, sealed(part.write(value))])),
  };
  const files: Zippable = { [MANIFEST]: [strToU8(JSON.stringify(manifest)), { mtime }] };
  const folderOf = namer();
  for (const { savedAt, job } of all) {
    const folder = folderOf(job.name.replace(/\.[hH]$/, ""));
    const nameOf = namer();
    for (const { name, text, encoding } of readable(job))
      files[`programs/${folder}/${nameOf(name)}`] = [encode(text, encoding), { mtime: zipTime(savedAt) }];
  }
  for (const { part, value } of beside)
    for (const [path, text] of Object.entries(part.files?.(value) ?? {})) files[path] = [strToU8(text), { mtime }];
  return zipSync(files, { level: 6 });
}

/** True for bytes that may be an archive: every zip begins like this. */
export const looksPacked = (bytes: Uint8Array): boolean => bytes[0] === 0x50 && bytes[1] === 0x4b;

/** The bytes of the manifest. Nothing else of the file is ever unpacked, so its paths are harmless. */
function manifestOf(bytes: Uint8Array, limits: ArchiveLimits): Uint8Array | ArchiveProblem {
  const files = packedFiles(bytes);
  if (files.length > limits.entries) return "tooLarge";
  const manifest = files.find(({ name }) => name === MANIFEST);
  return manifest ? (unpackedFile(manifest, limits.unpacked) ?? "tooLarge") : "notAnArchive";
}

/** The works of a manifest, and the names of those that cannot be read. */
function worksOf(raw: readonly unknown[]): Pick<ReadArchive, "works" | "unread"> {
  const works: ArchivedWork[] = [];
  const unread: string[] = [];
  for (const [i, each] of raw.entries()) {
    const { work, name } = isRecord(each) ? each : {};
    const file = readSave(unsealed(each));
    if (file)
      works.push({ work: typeof work === "string" ? work.slice(0, 100) : "", savedAt: file.savedAt, job: file.job });
    else unread.push(typeof name === "string" && name !== "" ? name.slice(0, 100) : `${i + 1}`);
  }
  return { works, unread };
}

function contentOf(raw: Readonly<Record<string, unknown>>): ReadArchive {
  const parts = eachPart((part, name) => part.read(unsealed(raw[name])));
  const unreadParts = PART_NAMES.filter((name) => raw[name] !== undefined && parts[name] === null);
  return { ...worksOf(Array.isArray(raw["works"]) ? raw["works"] : []), ...parts, unreadParts };
}

/** Reads an archive, or says why not. Never throws, and never unpacks beyond the limits. */
export function readArchive(
  bytes: Uint8Array,
  limits: ArchiveLimits = ARCHIVE_LIMITS,
): ReadArchive | { readonly problem: ArchiveProblem } {
  if (!looksPacked(bytes)) return { problem: "notAnArchive" };
  if (bytes.length > limits.packed) return { problem: "tooLarge" };
  try {
    const manifest = manifestOf(bytes, limits);
    if (typeof manifest === "string") return { problem: manifest };
    const raw: unknown = JSON.parse(strFromU8(manifest));
    const format = isRecord(raw) ? String(raw["format"]) : "";
    if (!isRecord(raw) || !format.startsWith(FORMAT)) return { problem: "notAnArchive" };
    if (Number(format.slice(FORMAT.length)) > EDITION) return { problem: "newer" };
    if (Array.isArray(raw["works"]) && raw["works"].length > limits.works) return { problem: "tooLarge" };
    return contentOf(raw);
  } catch {
    return { problem: "damaged" };
  }
}
