import { strToU8, zipSync, type Zippable } from "fflate";
import { safeFileName } from "../base/file-name.ts";
import { jsonGauge, readJson } from "../../program/files/bounded.ts";
import { packedFiles, unpackedFileText } from "../base/unpack.ts";
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
  /** Names of single rows of these parts that cannot be read; the others are. */
  readonly unreadRows: readonly string[];
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

/** Makes names unique, ignoring case: the second `A` becomes `A (2)`. The extension stays at the end. */
function namer(): (name: string) => string {
  const taken = new Set<string>();
  return (name) => {
    const [, stem = "", ending = ""] = /^(.*?)(\.[^.]{0,8})?$/s.exec(safeFileName(name)) ?? [];
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

/**
 * Packs works and other parts into one file. `isPrinted`: with the files that a control reads; without, nothing is
 * calculated.
 */
export function writeArchive(
  { works: all = [], ...given }: Partial<ArchiveContent>,
  isPrinted = true,
): Uint8Array<ArrayBuffer> {
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
      // Whole seconds: saves are distinguished by less, and how many there were depends on the machine.
      ...sealed({ version: SAVE_VERSION, savedAt: savedAt - (savedAt % 1000), job }),
    })),
    ...Object.fromEntries(beside.map(({ name, part, value }) => [name, sealed(part.write(value))])),
  };
  const files: Zippable = { [MANIFEST]: [strToU8(JSON.stringify(manifest)), { mtime }] };
  const folderOf = namer();
  for (const { savedAt, job } of isPrinted ? all : []) {
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

/** The data of the manifest. Nothing else of the file is ever unpacked, so its paths are harmless. */
function manifestOf(bytes: Uint8Array, limits: ArchiveLimits): { readonly raw: unknown } | ArchiveProblem {
  const files = packedFiles(bytes);
  if (files.length > limits.entries) return "tooLarge";
  const manifest = files.find(({ name }) => name === MANIFEST);
  if (!manifest) return "notAnArchive";
  const text = unpackedFileText(manifest, limits.unpacked, jsonGauge());
  return text === null ? "tooLarge" : { raw: readJson(text) };
}

/** The works of a manifest, and the names of those that cannot be read or are beyond the limit. */
function worksOf(raw: readonly unknown[], most: number): Pick<ReadArchive, "works" | "unread"> {
  const works: ArchivedWork[] = [];
  const unread: string[] = [];
  for (const [i, each] of raw.entries()) {
    const { work, name } = isRecord(each) ? each : {};
    const file = works.length < most ? readSave(unsealed(each)) : null;
    if (file)
      works.push({ work: typeof work === "string" ? work.slice(0, 100) : "", savedAt: file.savedAt, job: file.job });
    else unread.push(typeof name === "string" && name !== "" ? name.slice(0, 100) : `${i + 1}`);
  }
  return { works, unread };
}

function contentOf(raw: Readonly<Record<string, unknown>>, most: number): ReadArchive {
  const parts = eachPart((part, name) => part.read(unsealed(raw[name])));
  const unreadParts = PART_NAMES.filter((name) => raw[name] !== undefined && parts[name] === null);
  const unreadRows = PART_NAMES.flatMap(
    (name) => PARTS[name].unread?.(unsealed(raw[name])).map((row) => row.name) ?? [],
  );
  return { ...worksOf(Array.isArray(raw["works"]) ? raw["works"] : [], most), ...parts, unreadParts, unreadRows };
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
    const { raw } = manifest;
    const format = isRecord(raw) ? String(raw["format"]) : "";
    if (!isRecord(raw) || !format.startsWith(FORMAT)) return { problem: "notAnArchive" };
    if (Number(format.slice(FORMAT.length)) > EDITION) return { problem: "newer" };
    return contentOf(raw, limits.works);
  } catch {
    return { problem: "damaged" };
  }
}
