import { expect, test } from "vitest";
import { glossary as de } from "../../../i18n/de/glossary.ts";
import { glossary as en } from "../../../i18n/en/glossary.ts";
import { glossary as fr } from "../../../i18n/fr/glossary.ts";
import { glossary as zh } from "../../../i18n/zh/glossary.ts";
import { TERMS } from "../../../i18n/glossary-text.ts";
import { termParts } from "./term-parts.ts";
import { usingParameters } from "../../../features/guide/term-uses.ts";

const marked = (...of: Parameters<typeof termParts>) =>
  termParts(...of).map((parts) => parts.map(({ text, term }) => (term === null ? text : `[${text}|${term}]`)).join(""));

test("a term links to the glossary at its first use, and the longest name counts", () => {
  expect(marked(["The nose radius stays.", "Each pass, three passes; the nose radius again."], en)).toEqual([
    "The [nose radius|noseRadius] stays.",
    "Each [pass|pass], three passes; the nose radius again.",
  ]);
  expect(marked(["Cutting speeds and set-up clearance"], en, { before: ["the cutting speed"] })).toEqual([
    "Cutting speeds and [set-up clearance|setupClearance]",
  ]);
  expect(marked(["Oversize, and what an oversize is"], en, { but: "oversize" })).toEqual([
    "Oversize, and what an oversize is",
  ]);
});

test("terms are found in sentences of each language, and no text is lost", () => {
  expect(marked(["Zwei Aufmaße; aufmaßlos; der Schneidenradius"], de)).toEqual([
    "Zwei [Aufmaße|oversize]; aufmaßlos; der [Schneidenradius|noseRadius]",
  ]);
  expect(
    marked(["Drei Sätze, zwei Absätze; lange Späne in den Zyklen; die Platte am Satzende, ein Spann"], de),
  ).toEqual([
    "Drei [Sätze|block], zwei [Absätze|shoulder]; lange [Späne|chip] in den [Zyklen|cycle]; die [Platte|insert] am Satzende, ein Spann",
  ]);
  expect(marked(["L’outil passe dessous ; la gorge est plongée. La deuxième passe, et une plongée"], fr)).toEqual([
    "L’outil passe dessous ; la [gorge|recess] est plongée. La deuxième [passe|pass], et une [plongée|plunging]",
  ]);
  expect(marked(["Il n’est pas sûr du pas des pièces brutes"], fr)).toEqual([
    "Il n’est pas sûr du [pas|pitch] des [pièces brutes|blank]",
  ]);
  expect(marked(["刀尖半径与余量"], zh)).toEqual(["[刀尖半径|noseRadius]与[余量|oversize]"]);
  for (const [glossary, language] of [
    [en, "en"],
    [de, "de"],
    [fr, "fr"],
    [zh, "zh"],
  ] as const) {
    const texts = TERMS.map((id) => glossary[id].text);
    expect(termParts(texts, glossary).map((parts) => parts.map(({ text }) => text).join(""))).toEqual(texts);
    for (const id of TERMS) {
      const [parts = []] = termParts([glossary[id].name], glossary);
      expect(
        parts.map(({ term }) => term),
        `${language} ${id}`,
      ).toContain(id === "pitch" && language === "fr" ? null : id);
    }
  }
});

test.each([
  [en, "Program it, then program the groove wall. To program X you need a program.", ["recess", "program"]],
  [en, "The material that passes the edge; each pass counts", ["pass"]],
  [en, "The feed leaves grooves; a groove between two walls", ["recess"]],
  [en, "the corner without its rounding; CHF chamfers the corner; a chamfer of 1 mm", ["cornerElement"]],
  [de, "Im Schnitt hat die Kehle die Form; die Ecke ohne Rundung", []],
  [de, "Das Aufmaß zum Plandrehen", []],
  [fr, "n = 9 / Q463, arrondi au-dessus ; sans son arrondi ; arrondie à 0,6", []],
  [fr, "un chanfrein ou un arrondi", ["cornerElement"]],
  [fr, "Elle ne contrôle pas, l’écart ne se calcule pas", []],
  [fr, "le long du contour, dégagement, puis Dégagement en Z ; outil face au brut", ["contour", "blank"]],
  [zh, "这 2 mm 是车端面的余量，薄的余量；锥面下各刀的终点像台阶", ["face"]],
  [zh, "留下 0.8 mm 的圆角；余量 0.3", ["oversize"]],
] as const)("a word with another meaning is no term (%#)", (glossary, text, terms) => {
  const [parts = []] = termParts([text], glossary);
  expect(parts.flatMap(({ term }) => term ?? [])).toEqual(terms);
});

test("a parameter that leads to a term is among its uses once", () => {
  const uses = usingParameters("infeed");
  expect(uses.map(({ q }) => q)).toContain("Q463");
  expect(new Set(uses.map(({ text }) => text)).size).toBe(uses.length);
  expect(uses.every(({ q }) => q.startsWith("Q"))).toBe(true);
});
