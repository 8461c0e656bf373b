import { acting, kept, menu } from "virtual:cycle-menu";
import { cleanup, render, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, describe, expect, test } from "vitest";
import { LANGUAGES } from "../../../i18n/languages.ts";
import { menuWords, type MenuWords } from "../../../i18n/menu-words.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { CycleChooser } from "./CycleChooser.tsx";
import { useRecent } from "./recent.ts";
import { unofferedCycles } from "./menu.ts";
import { findCycles, findUnoffered } from "./search.ts";

const all = LANGUAGES.map(menuWords);
const found = (typed: string, words: readonly MenuWords[] = all) => findCycles(menu, typed, words);
const groupsOf = (typed: string) => new Set(found(typed).map(({ group }) => group));

describe("typed text finds", () => {
  test.each(menu.map(({ number }) => number))("%i by its number first", (number) =>
    expect(found(String(number))[0]?.number).toBe(number),
  );

  test.each(LANGUAGES.flatMap((language) => menu.map(({ number }) => [language, number] as const)))(
    "in %s the name of %i",
    (language, number) => {
      const name = menuWords(language).of[number]?.name ?? "";
      expect(found(name).map((cycle) => cycle.number)).toContain(number);
      expect(found(name.toUpperCase()).map((cycle) => cycle.number)).toContain(number);
    },
  );

  test.each([
    ["step", "longitudinal"],
    ["Absatz", "longitudinal"],
    ["epaulement", "longitudinal"],
    ["ÉPAULEMENT", "longitudinal"],
    ["台阶", "longitudinal"],
    ["bore", "longitudinal"],
    ["face", "transverse"],
    ["plandrehen", "transverse"],
    ["dressage", "transverse"],
    ["端面", "transverse"],
    ["slot", "recessTurning"],
    ["einstich", "recessTurning"],
    ["nut", "recessTurning"],
    ["gorge", "recessTurning"],
    ["切槽", "recessTurning"],
  ])("by %s one of %s", (typed, group) => expect(groupsOf(typed)).toContain(group));

  test("the name of DIN/ISO", () => expect(found("G820")).toEqual(found("820")));
  test("only cycles that match every word", () => {
    expect(found("shoulder xyzzy")).toEqual([]);
    expect(found("82 contour").every(({ number }) => String(number).startsWith("82"))).toBe(true);
  });

  test("no word of another language while only one is here", () =>
    expect(found("épaulement", all.slice(0, 1))).toEqual([]));
});

describe("cycles that cannot be chosen here are found with the reason", () => {
  const beside = (typed: string, inProgram: boolean) =>
    findUnoffered(unofferedCycles(inProgram), typed, all).map(({ number, why }) => `${number} ${why}`);

  test.each(acting.map(({ number }) => number))("%i acts in a program, and can be put into one", (number) => {
    expect(beside(String(number), false)).toEqual([`${number} acts`]);
    expect(beside(String(number), true)).toEqual([]);
  });
  test.each(kept.map((number) => [number]))("%i is not simulated, wherever it is searched", (number) => {
    for (const inProgram of [false, true]) expect(beside(String(number), inProgram)).toEqual([`${number} kept`]);
    for (const words of all) expect(beside(words.kept[number] ?? "", true)).toContain(`${number} kept`);
  });
  test("a word of another language finds it too, nonsense nothing", () => {
    expect(beside("hobbing", false)).toEqual(["880 kept"]);
    expect(beside("880 xyzzy", false)).toEqual([]);
  });

  afterEach(cleanup);
  const searchFor = async (typed: string, inProgram: boolean) => {
    const user = userEvent.setup();
    changeSettings({ language: "en" });
    render(<CycleChooser inProgram={inProgram} ways={[{ name: "Take", short: "Take", go: () => undefined }]} />);
    await user.type(screen.getByRole("searchbox"), typed);
  };
  test("the start page says where 800 can be inserted", async () => {
    await searchFor("800", false);
    expect(screen.getByRole("status").textContent?.trim()).toMatch(
      /^Cycle 800, .*: takes effect only within a program\./,
    );
  });
  test("a program takes 800 like any cycle", async () => {
    await searchFor("800", true);
    expect(screen.getByRole("button", { name: /^Cycle 800, .*: Take$/ })).toBeDefined();
  });
  test("what is found besides cycles is counted without the word cycle", async () => {
    const user = userEvent.setup();
    changeSettings({ language: "en" });
    const more = (sought: string | null) => ({
      count: sought === null ? 0 : 1,
      best: { name: "Undercut by name", go: () => undefined },
      isNamed: true,
      shown: null,
    });
    render(<CycleChooser more={more} ways={[{ name: "Take", short: "Take", go: () => undefined }]} />);
    await user.type(screen.getByRole("searchbox"), "DIN 76-B 2");
    const said = screen.getByRole("status").textContent ?? "";
    expect(said).toContain("Undercut by name");
    expect(said).not.toMatch(/cycle/i);
  });
  test("a program says that 880 is not simulated", async () => {
    await searchFor("880", true);
    expect(screen.getByRole("status").textContent?.trim()).toMatch(
      /^Cycle 880, Gear hobbing: shown in a program but not simulated/,
    );
  });
});

describe("the chooser", () => {
  let taken: number[] = [];
  beforeEach(() => {
    taken = [];
    localStorage.clear();
    useRecent.setState({ cycles: [] });
    changeSettings({ language: "en" });
    render(<CycleChooser ways={[{ name: "Take", short: "Take", go: (cycle) => taken.push(cycle) }]} />);
  });
  afterEach(cleanup);
  const first = menu[0]?.number ?? 0;
  const last = menu.at(-1)?.number ?? 0;

  test("Enter in the search takes the first cycle found", async () => {
    const user = userEvent.setup();
    await user.type(screen.getByRole("searchbox"), `${last}{Enter}`);
    expect(taken).toEqual([last]);
  });

  test("the chosen cycle is first among the last used ones, and is saved on the device", async () => {
    const user = userEvent.setup();
    for (const number of [first, last])
      await user.click(screen.getByRole("button", { name: new RegExp(`^Cycle ${number}, .*: Take$`) }));
    const recent = within(screen.getByRole("region", { name: "Recently used" })).getAllByRole("button");
    expect(recent.map((button) => button.getAttribute("aria-label")?.replace(/\D/g, ""))).toEqual([
      String(last),
      String(first),
    ]);
    expect(JSON.parse(localStorage.getItem("turnwise/recent-cycles") ?? "")).toEqual([last, first]);
  });

  test("a word of another language finds once its words are here, and Escape shows all again", async () => {
    const user = userEvent.setup();
    const box = screen.getByRole("searchbox");
    await user.type(box, "epaulement");
    expect((await screen.findAllByRole("button", { name: /^Cycle 81\d, / })).length).toBeGreaterThan(0);
    await user.type(box, "{Escape}");
    expect(screen.getAllByRole("region").length).toBe(new Set(menu.map(({ group }) => group)).size);
  });

  test("a group collapses", async () => {
    const user = userEvent.setup();
    const [head] = screen.getAllByRole("button", { expanded: true });
    const before = screen.getAllByRole("listitem").length;
    if (head) await user.click(head);
    expect(screen.getAllByRole("listitem").length).toBeLessThan(before);
  });
});
