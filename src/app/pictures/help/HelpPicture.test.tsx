import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, beforeAll, expect, test } from "vitest";
import { catalogue } from "../../../cycles/index.ts";
import type { Cycle } from "../../../cycles/define.ts";
import type { Language } from "../../../i18n/languages.ts";
import type { Numbers } from "../../../view/help/lettering.ts";
import { fetchTexts } from "../../base/settings/loaded-texts.ts";
import { HelpPicture } from "./HelpPicture.tsx";

beforeAll(async () => {
  await fetchTexts("en");
  await fetchTexts("de");
});
afterEach(cleanup);

const cycle = catalogue.find((c) => c.contour === "own" && c.evidence === "A") as Cycle;
const example: Numbers = Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, p.example]));
const picture = (
  values: Numbers | null,
  activeQ: string | null,
  language: Language = "en",
  partial: Numbers = values ?? {},
) => (
  <HelpPicture
    cycle={cycle}
    values={values}
    partial={partial}
    given={{ contour: null, start: null }}
    activeQ={activeQ}
    language={language}
  />
);
const name = () => screen.getByRole("img").getAttribute("aria-label") ?? "";
const active = () => [...document.querySelectorAll("svg text.active")].map((e) => e.textContent);

test("its name has the active dimension and its value in words", () => {
  const { rerender } = render(picture(example, "Q491"));
  expect(name()).toMatch(/Highlighted: Q491 Start ⌀, diameter 75 mm\.$/);
  rerender(picture({ ...example, Q492: -0.5 }, "Q492", "de"));
  expect(name()).toContain("Z -0,5 mm");
  rerender(picture(example, "Q501"));
  expect(name()).toContain("1, chamfer");
  rerender(picture({ ...example, Q478: "auto" }, "Q478"));
  expect(name()).toContain("FAUTO");
});

test("the active dimension is in the picture with its value", () => {
  const { rerender } = render(picture(example, "Q494"));
  expect(active()).toEqual(["Z−55"]);
  rerender(picture({ ...example, Q494: -40.25 }, "Q494", "de"));
  expect(active()).toEqual(["Z−40,25"]);
});

test("invalid values leave the last valid drawing, dimmed, with a note", () => {
  const { rerender } = render(picture({ ...example, Q491: 80 }, "Q491"));
  expect(active()).toEqual(["⌀80"]);
  rerender(picture({ ...example, Q491: 50 }, "Q491", "en"));
  expect(active()).toEqual(["⌀80"]);
  expect(screen.getByRole("img").classList.contains("dimmed")).toBe(true);
  expect(name()).toContain("last valid drawing");
  rerender(picture(example, "Q491"));
  expect(screen.getByRole("img").classList.contains("dimmed")).toBe(false);
});

test("a missing value shows its Q number, and no number that nobody typed", () => {
  const { rerender } = render(picture(null, "Q491"));
  expect(active()).toEqual(["Q491"]);
  expect(name()).toContain("no value yet");
  expect(name()).toContain("Q numbers represent values");
  const texts = () => [...document.querySelectorAll("svg text")].map((e) => e.textContent);
  expect(texts().filter((text) => !/^Q\d+$/.test(text ?? ""))).toEqual([]);
  rerender(picture(null, "Q494", "en", { Q491: 61.37, Q492: 0.8 }));
  expect(active()).toEqual(["Q494"]);
  expect(texts()).toEqual(expect.arrayContaining(["⌀61.37", "Z0.8", "Q493"]));
  expect(screen.getByRole("img").classList.contains("dimmed")).toBe(false);
});

test("a removed value leaves the drawing unchanged, with its Q number", () => {
  const { rerender } = render(picture(example, "Q494"));
  const contour = () => document.querySelector("svg .line-contour")?.getAttribute("d");
  const before = contour();
  const { Q494: _, ...partial } = example;
  rerender(picture(null, "Q494", "en", partial));
  expect(active()).toEqual(["Q494"]);
  expect(contour()).toBe(before);
});

test("a free contour that is missing draws nothing and does not break", () => {
  const free = catalogue.find((c) => c.contour === "free" && c.evidence === "A") as Cycle;
  render(
    <HelpPicture cycle={free} values={null} given={{ contour: null, start: null }} activeQ="Q463" language="en" />,
  );
  expect(document.querySelector("svg")?.outerHTML).not.toMatch(/NaN|Infinity/);
});
