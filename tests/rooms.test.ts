import { describe, expect, test } from "vitest";
import { code, sources } from "./sources.ts";

const all = sources("src");
const layerOf = (path: string) => path.split("/")[1] ?? "";
/** The layers of the page. */
const PAGE = ["app", "features", "shell"];

/** Rooms of the page from the bottom up: each imports only rooms below; features do not import each other. */
const ROOMS = [
  "base",
  "place",
  "document",
  "calculation",
  "records",
  "findings",
  "pictures",
  "fields",
  "features",
  "shell",
];

describe("rooms of the page", () => {
  /** The room of a file, and the feature; null outside the page. */
  const placeOf = (path: string) => {
    const [, layer = "", name = ""] = path.split("/");
    if (!PAGE.includes(layer)) return null;
    return { floor: ROOMS.indexOf(layer === "app" ? name : layer), feature: layer === "features" ? name : null };
  };
  /** Tests may import a room through those above it. */
  const inPage = all.filter((s) => placeOf(s.path) && !/\.test\.tsx?$/.test(s.path));

  test("every file of the page stands in a room", () => {
    expect(inPage.filter((s) => placeOf(s.path)?.floor === -1).map((s) => s.path)).toEqual([]);
    expect(inPage.length).toBeGreaterThan(500);
  });

  test.each(ROOMS)("%s imports downwards only", (room) => {
    const wrong = inPage.flatMap((s) => {
      const here = placeOf(s.path);
      if (!here || ROOMS[here.floor] !== room) return [];
      return s.imports.flatMap(({ target }) => {
        const there = placeOf(target);
        const isBelow =
          !there || there.floor < here.floor || (there.floor === here.floor && there.feature === here.feature);
        return isBelow ? [] : [`${s.path} → ${target}`];
      });
    });
    expect(wrong).toEqual([]);
  });
});

test("a feature is imported only by its index, which fetches its parts, and by its part of the first screen", () => {
  const featureOf = (path: string) => (layerOf(path) === "features" ? path.split("/")[2] : null);
  const wrong = all
    .filter((s) => !/\.test\.tsx?$/.test(s.path))
    .flatMap((s) =>
      s.imports.flatMap(({ target }) => {
        const feature = featureOf(target);
        const isKnown =
          !feature ||
          feature === featureOf(s.path) ||
          ["index", "first"].some((name) => target === `src/features/${feature}/${name}.ts`);
        return isKnown ? [] : [`${s.path} → ${target}`];
      }),
    );
  expect(wrong).toEqual([]);
  const indexes = all.filter((s) => /^src\/features\/[^/]+\/index\.ts$/.test(s.path));
  expect(indexes.length).toBeGreaterThan(10);
  expect(indexes.filter((s) => / from "/.test(code(s.text))).map((s) => s.path)).toEqual([]);
});

/** Folders of a layer from the bottom up; "" contains its files outside any folder. */
const FOLDERS: Readonly<Record<string, readonly string[]>> = {
  kernel: [
    "",
    "geometry",
    "area",
    "plan",
    "reach",
    "contour",
    "fit",
    "thread",
    "solve",
    "time",
    "plane",
    "cutter",
    "free",
    "strategy",
  ],
  program: [
    "files",
    "values",
    "machine",
    "tools",
    "iso-codes",
    "tool-files",
    "tool-sheets",
    "state",
    "clamping",
    "motion",
    "blocks",
    "run",
    "job",
    "drawing",
    "edits",
    "compare",
  ],
};

describe.each(Object.entries(FOLDERS))("folders of %s", (layer, folders) => {
  const floorOf = (path: string) => folders.indexOf(path.split("/").slice(2, -1)[0] ?? "");
  const files = all.filter((s) => layerOf(s.path) === layer && !/\.test\.ts$/.test(s.path));

  test.each(folders)("%s imports downwards only", (folder) => {
    const here = folders.indexOf(folder);
    const own = files.filter((s) => floorOf(s.path) === here);
    expect(own.length).toBeGreaterThan(1);
    const wrong = own.flatMap((s) =>
      s.imports
        .filter((i) => i.relative && layerOf(i.target) === layer && floorOf(i.target) > here)
        .map((i) => `${s.path} → ${i.target}`),
    );
    expect(wrong).toEqual([]);
  });

  test("every file stands in one of them", () => {
    expect(files.filter((s) => floorOf(s.path) === -1).map((s) => s.path)).toEqual([]);
  });
});

/** All mutable module variables, each with the reason why it is no store: only its own file may access it. */
const STATE: Readonly<Record<string, string>> = {
  "src/app/calculation/advice.ts: newest": "the program whose variants are tried one after the other, in the worker",
  "src/app/base/database.ts: unanswered":
    "the call that the browser has not answered; notices say what follows from it",
  "src/app/base/random-id.ts: pageDrawCount": "goes on counting where the device keeps nothing",
  "src/app/calculation/played-milling.ts: asked": "the outcome whose milling was asked for, until its answer is here",
  "src/app/fields/blocks/choose-block.ts: isChosen": "spans one call: a block opened from the picture is marked there",
  "src/app/fields/blocks/half-typed.ts: halfTypedBlock":
    "looked at with each key, before the text is run; its store is the held picture",
  "src/app/fields/blocks/session.ts: open": "CodeMirror's state is replaced with each transaction, and drawn by itself",
  "src/app/fields/blocks/session.ts: view": "the one editor of the page, which is no data",
  "src/app/records/course/working-time.ts: since": "when the running stretch began; what it adds up to is a record",
  "src/features/offline/offline.ts: registration":
    "the browser's own object; what it means is in the store of the version",
};

test("module-level state is listed, and at most ten", () => {
  const held = all
    .filter((s) => PAGE.includes(layerOf(s.path)) && !/\.test\.tsx?$/.test(s.path))
    .flatMap((s) => [...code(s.text).matchAll(/^let (\w+)/gm)].map(([, name]) => `${s.path}: ${name}`));
  expect(held.sort()).toEqual(Object.keys(STATE).sort());
  expect(held.length).toBeLessThanOrEqual(10);
});
