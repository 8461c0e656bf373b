import { expect, test } from "vitest";
import type { FileHandle, FolderHandle } from "./file-handle.ts";
import { filesOfDrop, filesOfFolder, filesOfList } from "./folder.ts";
import { DEEPEST_FOLDER, LARGEST_PROGRAM, MOST_FILES } from "../../base/limits.ts";

type Member = FolderHandle | (FileHandle & { readonly kind: "file" });

const file = (name: string, size = 10): FileHandle & { readonly kind: "file" } => ({
  kind: "file",
  name,
  getFile: async () => Object.defineProperty(new File([], name), "size", { value: size }),
  createWritable: () => Promise.reject(new Error("not here")),
});
const folder = (name: string, members: readonly Member[]): FolderHandle => ({
  kind: "directory",
  name,
  values: async function* () {
    yield* members;
  },
});
const namesIn = async (root: FolderHandle) => {
  const { files, ...rest } = await filesOfFolder(root);
  return { names: files.map((each) => each.file.name), ...rest };
};

test("programs and tables of all folders are taken, outer ones first; hidden files and others are not", async () => {
  const inner = folder("sub", [file("x.h"), file(".lock.h"), folder(".git", [file("y.h")])]);
  expect(
    await namesIn(
      folder("job", [inner, file("MAIN.H"), file("photo.jpg"), file("points.PNT"), file("~tmp.h"), file("noending")]),
    ),
  ).toEqual({ names: ["MAIN.H", "points.PNT", "x.h"], skipped: 2, isCut: false });
});

test("files and folders beyond the limits are left out, and reported", async () => {
  const many = await namesIn(
    folder(
      "many",
      Array.from({ length: MOST_FILES + 7 }, (_, i) => file(`${i}.h`)),
    ),
  );
  expect([many.names.length, many.isCut]).toEqual([MOST_FILES, true]);
  expect(await namesIn(folder("large", [file("a.h", LARGEST_PROGRAM - 3), file("b.h", 4), file("c.h", 3)]))).toEqual({
    names: ["a.h", "c.h"],
    skipped: 0,
    isCut: true,
  });
  const deep = Array.from({ length: DEEPEST_FOLDER + 2 }).reduce<FolderHandle>(
    (inside) => folder("in", [file("a.h"), inside]),
    folder("last", [file("lost.h")]),
  );
  const { names, isCut } = await namesIn(deep);
  expect([names.length, names.includes("lost.h"), isCut]).toEqual([DEEPEST_FOLDER, false, true]);
});

test("unreadable files are counted, and the others are taken", async () => {
  const broken = { ...file("b.h"), getFile: () => Promise.reject(new Error("gone")) };
  const { files, skipped } = await filesOfDrop([
    { handle: file("a.h"), entry: null },
    { handle: folder("f", [broken]), entry: null },
  ]);
  expect([files.map((each) => each.file.name), skipped]).toEqual([["a.h"], 1]);
});

test("a folder input follows the same rules", async () => {
  const listed = (path: string) =>
    Object.defineProperty(new File(["1"], path.replace(/.*\//, "")), "webkitRelativePath", { value: path });
  const { files, skipped } = await filesOfList(
    ["job/MAIN.H", "job/.git/a.h", "job/sub/x.i", "job/part.step"].map(listed),
  );
  expect([files.map((each) => each.file.name), skipped]).toEqual([["MAIN.H", "x.i"], 1]);
});
