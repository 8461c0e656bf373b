import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, beforeAll, expect, test } from "vitest";
import { catalogue } from "../../cycles/index.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Language } from "../../i18n/languages.ts";
import type { Numbers } from "../../view/help/lettering.ts";
import { fetchTexts } from "../settings/loaded-texts.ts";
import { HelpPicture } from "./HelpPicture.tsx";

beforeAll(async () => {
  await fetchTexts("en");
  await fetchTexts("de");
});
afterEach(cleanup);

const cycle = catalogue.find((c) => c.contour === "own" && c.evidence === "A") as Cycle;
const example: Numbers = Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, p.example]));
const picture = (values: Numbers | null, activeQ: string | null, language: Language = "en", partial: Numbers = values ?? {}) => (
  <HelpPicture cycle={cycle} values={values} partial={partial} given={{ contour: null, start: null }} activeQ={activeQ}
    language={language} />
);
const name = () => screen.getByRole("img").getAttribute("aria-label") ?? "";
const active = () => [...document.querySelectorAll("svg text.active")].map((e) => e.textContent);

test("its name says in words what is dimensioned and its value", () => {
  const { rerender } = render(picture(example, "Q491"));
  expect(name()).toMatch(/Highlighted: Q491 Start ⌀, diameter 75 mm\.$/);
  rerender(picture({ ...example, Q492: -0.5 }, "Q492", "de"));
  expect(name()).toContain("Z -0,5 mm");
  rerender(picture(example, "Q501"));
  expect(name()).toContain("1, chamfer");
  rerender(picture({ ...example, Q478: "auto" }, "Q478"));
  expect(name()).toContain("FAUTO");
});

test("the active dimension stands in the picture with its value", () => {
  const { rerender } = render(picture(example, "Q494"));
  expect(active()).toEqual(["Z−55"]);
  rerender(picture({ ...example, Q494: -40.25 }, "Q494", "de"));
  expect(active()).toEqual(["Z−40,25"]);
});

test("missing or impossible values leave the last possible drawing, dimmed, and it says so", () => {
  const { rerender } = render(picture({ ...example, Q491: 80 }, "Q491"));
  expect(active()).toEqual(["⌀80"]);
  for (const bad of [null, { ...example, Q491: 50 }]) {
    rerender(picture(bad, "Q491", "en", { Q492: 0 }));
    expect(active()).toEqual(["⌀80"]);
    expect(screen.getByRole("img").classList.contains("dimmed")).toBe(true);
    expect(name()).toContain("no value yet");
    expect(name()).toContain("last possible drawing");
  }
  rerender(picture(example, "Q491"));
  expect(screen.getByRole("img").classList.contains("dimmed")).toBe(false);
});

test("before there was a drawing it shows the printed example, dimmed", () => {
  render(picture(null, "Q491"));
  expect(active()).toEqual(["⌀75"]);
  expect(name()).toContain("printed example");
});

test("a free contour that is missing draws nothing and does not break", () => {
  const free = catalogue.find((c) => c.contour === "free" && c.evidence === "A") as Cycle;
  render(<HelpPicture cycle={free} values={null} given={{ contour: null, start: null }} activeQ="Q463" language="en" />);
  expect(document.querySelector("svg")?.outerHTML).not.toMatch(/NaN|Infinity/);
});
