import { ENDINGS, type Chosen, type FileHandle, type FolderHandle } from "./file-handle.ts";
import { DEEPEST_FOLDER, LARGEST_PROGRAM, MOST_FILES } from "../../base/limits.ts";

/** Content of a folder. */
export interface FolderContent {
  readonly files: readonly Chosen[];
  /** Files that are no program texts, by their names: hidden ones are not counted. */
  readonly skipped: number;
  /** The folder exceeds the limits. */
  readonly isCut: boolean;
}

const isHidden = (name: string): boolean => name.startsWith(".") || name.startsWith("~");
const ours = new Set(ENDINGS.map((ending) => ending.toUpperCase()));
const isOurs = (name: string): boolean => ours.has(/\.[^.]*$/.exec(name)?.[0].toUpperCase() ?? "");

/** A member of a folder, independent of the browser API. */
type Member =
  | { readonly kind: "folder"; readonly name: string; readonly members: () => Promise<readonly Member[]> }
  | {
      readonly kind: "file";
      readonly name: string;
      readonly file: () => Promise<Chosen>;
    };

/** Walks folders, outer files first, up to the limits. Unreadable members are left out. */
async function gather(roots: readonly Member[]): Promise<FolderContent> {
  const files: Chosen[] = [];
  let [skipped, size, isCut] = [0, 0, false];
  let level: readonly Member[] = roots;
  for (let depth = 0; level.length > 0; depth += 1) {
    if (depth > DEEPEST_FOLDER) return { files, skipped, isCut: true };
    const inner: Member[] = [];
    for (const member of level) {
      if (isHidden(member.name)) continue;
      try {
        if (member.kind === "folder") inner.push(...(await member.members()));
        else if (!isOurs(member.name)) skipped += 1;
        else {
          const chosen = await member.file();
          if (files.length >= MOST_FILES || size + chosen.file.size > LARGEST_PROGRAM) {
            isCut = true;
            continue;
          }
          size += chosen.file.size;
          files.push(chosen);
        }
      } catch {
        skipped += 1;
      }
    }
    level = inner;
  }
  return { files, skipped, isCut };
}

const memberOfHandle = (handle: FolderHandle | FileHandle): Member =>
  "values" in handle
    ? {
        kind: "folder",
        name: handle.name,
        members: async () => {
          const members: Member[] = [];
          for await (const each of handle.values()) members.push(memberOfHandle(each));
          return members;
        },
      }
    : { kind: "file", name: handle.name, file: async () => ({ file: await handle.getFile(), handle }) };

/** All files of a directory entry: browsers hand over a hundred at a time. */
async function entriesIn(entry: FileSystemDirectoryEntry): Promise<readonly FileSystemEntry[]> {
  const reader = entry.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<readonly FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (some.length === 0) return all;
    all.push(...some);
  }
}

const memberOfEntry = (entry: FileSystemEntry): Member =>
  entry.isDirectory
    ? {
        kind: "folder",
        name: entry.name,
        members: async () => (await entriesIn(entry as FileSystemDirectoryEntry)).map(memberOfEntry),
      }
    : {
        kind: "file",
        name: entry.name,
        file: async () => ({
          file: await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject)),
          handle: null,
        }),
      };

/** Files of a chosen folder. */
export const filesOfFolder = (folder: FolderHandle): Promise<FolderContent> => gather([memberOfHandle(folder)]);

/** A dropped file or folder, as far as the browser gives access to it. */
export interface DroppedPart {
  readonly handle: FileHandle | FolderHandle | null;
  readonly entry: FileSystemEntry | null;
}

/** Files of dropped files and folders: by handles if the browser has them, else by entries. */
export const filesOfDrop = (dropped: readonly DroppedPart[]): Promise<FolderContent> =>
  gather(
    dropped.flatMap(({ handle, entry }) => {
      if (handle) return [memberOfHandle(handle)];
      return entry ? [memberOfEntry(entry)] : [];
    }),
  );

/** Files of a folder input: all of them, with their paths. */
export const filesOfList = (list: FileList | readonly File[] | null): Promise<FolderContent> =>
  gather(
    Array.from(list ?? []).flatMap((file): readonly Member[] => {
      const path = file.webkitRelativePath.split("/");
      if (path.length > DEEPEST_FOLDER + 2 || path.some(isHidden)) return [];
      return [{ kind: "file", name: file.name, file: async () => ({ file, handle: null }) }];
    }),
  );
