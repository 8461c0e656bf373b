import { describe, expect, test } from "vitest";
import { catalogue, cycleByNumber } from "../src/cycles/index.ts";
import type { ParamTextId } from "../src/cycles/index.ts";
import type { Kind } from "../src/cycles/params.ts";
import { typeset } from "../src/i18n/fr/typography/typeset.ts";
import { texts } from "../src/i18n/index.ts";
import { type Language, LANGUAGES } from "../src/i18n/languages.ts";
import { NC_LANGUAGES } from "../src/nc/nc-languages.ts";
import { ncLabels, ncWords } from "../src/i18n/nc-labels.ts";
import { checkNumber, readText } from "../src/program/values/field.ts";
import { RECALLED } from "./recalled-lists.ts";
import { projectFolder } from "./sources.ts";

const cycles = catalogue.map((cycle) => [cycle.number, cycle] as const);

/** Q number and value of each line, in the order of the printed examples. */
const PRINTED: Readonly<Record<number, string>> = {
  812:
    "Q215 0, Q460 2, Q491 75, Q492 0, Q493 50, Q494 -55, Q495 5, Q501 1, Q502 0.5, Q500 1.5, Q496 0, Q503 1, Q504 0.5, Q463 3, " +
    "Q478 0.3, Q483 0.4, Q484 0.2, Q505 0.2, Q506 0",
  820: "Q215 0, Q460 2, Q499 0, Q463 3, Q478 0.3, Q483 0.4, Q484 0.2, Q505 0.2, Q487 1, Q488 0, Q479 0, Q480 0, Q482 0, Q506 0",
  852:
    "Q215 0, Q460 2, Q491 75, Q492 -20, Q493 50, Q494 -50, Q495 5, Q501 1, Q502 0.5, Q500 1.5, Q496 5, Q503 1, Q504 0.5, Q478 " +
    "0.3, Q483 0.4, Q484 0.2, Q505 0.2, Q463 2, Q507 0, Q508 0, Q509 0, Q488 0",
};

/** Ranges printed on the page of each cycle. */
const RANGES: Readonly<Record<number, Readonly<Record<string, readonly [number, number]>>>> = {
  812: { Q463: [0.001, 999.999], Q483: [0, 99.999], Q215: [0, 3], Q501: [0, 2], Q503: [0, 2], Q506: [0, 2] },
  820: {
    Q215: [0, 3],
    Q460: [0, 999.999],
    Q499: [0, 2],
    Q463: [0, 99.999],
    Q478: [0, 99999.999],
    Q483: [0, 99.999],
    Q484: [0, 99.999],
    Q505: [0, 99999.999],
    Q487: [0, 1],
    Q488: [0, 99999.999],
    Q479: [0, 1],
    Q480: [-99999.999, 99999.999],
    Q482: [-99999.999, 99999.999],
    Q506: [0, 2],
  },
  852: { Q463: [0.001, 999.999], Q483: [0, 99.999], Q215: [0, 3], Q501: [0, 2], Q503: [0, 2], Q507: [0, 1] },
  800: { Q530: [0, 3] },
};

/** Parameters of recalled lists whose meaning a page of the control prints. */
const ATTESTED: Readonly<Record<number, readonly string[]>> = { 800: ["Q497", "Q530", "Q531"], 815: ["Q463", "Q478"] };
/** Cycles whose English name a page prints, but not their list. */
const NAMED: Readonly<Record<number, string>> = { 800: "ADJUST XZ SYSTEM", 815: "CONTOUR-PAR. TURNING" };

/** The same Q may measure different things in different cycles. */
const KINDS: Readonly<Record<string, Kind>> = {
  "812/Q463": "radial",
  "820/Q463": "axialDepth",
  "852/Q463": "axialDepth",
  "812/Q491": "diameter",
  "812/Q492": "axial",
  "812/Q483": "oversizeDiameter",
  "812/Q495": "angle",
  "820/Q480": "diameter",
  "820/Q482": "axial",
  "852/Q488": "feed",
  "852/Q508": "length",
  "812/Q506": "choice",
};

const FRENCH: Readonly<Record<string, string>> = {
  Q215: "Opération d'usinage (0/1/2/3)?",
  Q460: "Distance d'approche?",
  Q491: "Diamètre de départ du contour?",
  Q492: "Départ de contour Z?",
  Q493: "Diamètre fin de contour?",
  Q494: "Fin de contour Z?",
  "812/Q495": "Angle de surface du pourtour?",
  "852/Q495": "Angle du flanc?",
  Q501: "Type élément de départ (0/1/2)?",
  Q502: "Taille de l'élément de départ?",
  Q500: "Rayon au coin du contour?",
  "812/Q496": "Angle face transversale?",
  "852/Q496": "Angle du deuxième flanc?",
  Q503: "Type élément final (0/1/2)?",
  Q504: "Taille de l'élément final?",
  Q463: "Plongée max.?",
  Q478: "Avance d'ébauche?",
  Q483: "Surépaisseur diamètre ?",
  Q484: "Surépaisseur Z?",
  Q505: "Avance de finition?",
  Q506: "Lissage du contour (0/1/2)?",
  Q499: "Inverser contour (0-2)?",
  Q487: "Autoriser la plongée (0/1)?",
  Q488: "Avance plongée (0=autom.)?",
  Q479: "Limites d'usinage (0/1)?",
  Q480: "Valeur de limitation diamètre?",
  Q482: "Valeur limitation de coupe Z?",
  Q507: "Sens: (0= bidir. / 1=unidir.)?",
  Q508: "Largeur de décalage?",
  Q509: "Correction de prof. finition?",
};
const CHINESE: Readonly<Record<string, string>> = {
  Q215: "加工操作(0/1/2/3)?",
  Q460: "安全高度?",
  Q499: "逆轮廓(0-2)?",
  Q463: "最大切削深度?",
  Q478: "粗加工进给速率?",
  Q483: "直径余量?",
  Q484: "Z轴方向余量?",
  Q505: "精加工进给率?",
  Q487: "允许切入(0/1)?",
  Q488: "切入进给速率(0=自动)?",
  Q479: "加工极限(0/1)?",
  Q480: "直径极限值?",
  Q482: "Z轴切削极限值?",
  Q506: "轮廓平滑(0/1/2)?",
};
const prompts: Partial<Record<Language, Readonly<Record<string, string>>>> = { fr: FRENCH, zh: CHINESE };

const FRENCH_LABELS: Readonly<Record<string, string>> = {
  Q215: "OPERATIONS D'USINAGE",
  Q460: "DISTANCE D'APPROCHE",
  Q491: "DIAMETRE DEPART CONTOUR",
  Q492: "DEPART CONTOUR Z",
  Q493: "FIN CONTOUR X",
  Q494: "FIN DE CONTOUR Z",
  "812/Q495": "ANGLE PERIM. SURFACE",
  "852/Q495": "ANGLE FLANC",
  Q501: "TYPE ELEMENT DEPART",
  Q502: "TAILLE ELEMENT DEPART",
  Q500: "RAYON COIN CONTOUR",
  "812/Q496": "ANGLE FACE TRANSV.",
  "852/Q496": "ANGLE DU FLANC",
  Q503: "TYPE ELEMENT FINAL",
  Q504: "TAILLE ELEMENT FINAL",
  Q463: "PASSE MAX",
  Q478: "AVANCE EBAUCHE",
  Q483: "SUREPAISSEUR DIAMETRE",
  Q484: "SUREPAISSEUR Z",
  Q505: "AVANCE DE FINITION",
  Q506: "LISSAGE CONTOUR",
  Q499: "INVERSER CONTOUR",
  Q487: "PLONGEE",
  Q488: "AVANCE DE PLONGEE",
  Q479: "LIMITATION D'USINAGE",
  Q480: "VALEUR LIMITE X",
  Q482: "VALEUR LIMITE Z",
  Q507: "SENS USINAGE",
  Q508: "LARGEUR DECALAGE",
  Q509: "CORRECTION DE PROF.",
};
const ENGLISH_LABELS: Readonly<Record<string, string>> = {
  Q215: "MACHINING OPERATION",
  Q460: "SAFETY CLEARANCE",
  Q499: "REVERSE CONTOUR",
  Q463: "MAX. CUTTING DEPTH",
  Q478: "ROUGHING FEED RATE",
  Q483: "OVERSIZE FOR DIAMETER",
  Q484: "OVERSIZE IN Z",
  Q505: "FINISHING FEED RATE",
  Q487: "PLUNGE",
  Q488: "PLUNGING FEED RATE",
  Q479: "CONTOUR MACHINING LIMIT",
  Q480: "DIAMETER LIMIT VALUE",
  Q482: "LIMIT VALUE Z",
  Q506: "CONTOUR SMOOTHING",
};

describe.each(cycles)("cycle %i", (number, cycle) => {
  const params = Object.entries(cycle.params);

  const isPrinted = cycle.evidence === "A";

  test("lists its parameters and example values in their order, and tags what no page prints", () => {
    expect(params.map(([q, p]) => `${q} ${p.example}`).join(", ")).toBe((isPrinted ? PRINTED : RECALLED)[number]);
    expect(cycle.evidence).toMatch(/^(A|K[123])$/);
    for (const [q, p] of params)
      expect([q, p.evidence.startsWith("K")]).toEqual([q, !isPrinted && !(ATTESTED[number] ?? []).includes(q)]);
  });

  test("has the printed ranges, each with its evidence", () => {
    for (const [q, p] of params) {
      const printed = RANGES[number]?.[q];
      if (printed) expect([q, ...p.range, p.rangeEvidence]).toEqual([q, ...printed, "A"]);
      const takes = (n: number) => checkNumber({ ...p, id: q }, n) === null;
      expect([p.example, ...p.range].every(takes), q).toBe(true);
      expect([p.range[0] - 0.001, p.range[1] + 0.001, NaN].some(takes), q).toBe(false);
      expect(readText({ ...p, id: q }, "FAUTO").written === "auto", q).toBe(p.kind === "feed");
    }
  });

  test("has a program to compare with: a printed one where available", () => {
    const named = isPrinted ? `cycle-${number}-` : `cycle-${number}.h`;
    expect(projectFolder("tests/programs").filter((name) => name.startsWith(named))).not.toEqual([]);
  });

  test("names the manual section and the steps that it follows", () => {
    if (isPrinted) expect(cycle.manual?.section).toMatch(/^\d+\.\d+$/);
    else expect(cycle.manual).toBeNull();
    for (const language of LANGUAGES) {
      const words = texts(language).cycles.of[number as 812];
      expect([words.rough.length, words.finish.length]).toEqual([cycle.steps.rough, cycle.steps.finish]);
    }
  });

  test.each(LANGUAGES)("has all its texts in %s", (language) => {
    const { cycles, params: words } = texts(language);
    const text = cycles.of[number as 812];
    const sentences = [
      text.name,
      text.summary,
      ...text.description,
      ...text.rough,
      ...text.finish,
      ...text.notes,
      cycles.groups[cycle.group],
    ];
    for (const sentence of sentences) expect(sentence.trim()).not.toBe("");
    for (const [q, p] of params) {
      const { prompt, label, explanation } = words[p.text as ParamTextId];
      for (const said of [prompt, label, explanation]) expect(said.trim(), q).not.toBe("");
      expect(prompt, q).toMatch(/\?$/);
    }
  });

  test.each(LANGUAGES)("says what each choice means in %s", (language) => {
    for (const [q, p] of params) {
      const words = texts(language).params[p.text as ParamTextId];
      expect("choices" in words ? Object.keys(words.choices).map(Number) : [], q).toEqual(p.choices ?? []);
    }
  });

  test.runIf(isPrinted).each(["fr", "zh"] as const)("asks with the printed prompts in %s", (language) => {
    for (const [q, p] of params) {
      const printed = prompts[language]?.[`${number}/${q}`] ?? prompts[language]?.[q];
      const words = texts(language).params[p.text as ParamTextId];
      expect([q, words.printed]).toEqual([q, printed !== undefined]);
      if (printed !== undefined) expect([q, words.prompt]).toEqual([q, language === "fr" ? typeset(printed) : printed]);
    }
  });

  test("has the printed labels and names in NC text, and tags the others", () => {
    for (const [q, p] of params) {
      for (const language of NC_LANGUAGES)
        expect(ncLabels(language).label(p.text), q).toMatch(/^[A-Z0-9][A-Z0-9 .,'/()-]+$/);
      if (!isPrinted) continue;
      expect([q, ncLabels("fr").label(p.text)]).toEqual([q, FRENCH_LABELS[`${number}/${q}`] ?? FRENCH_LABELS[q]]);
      const word = ncWords("en").params[p.text as ParamTextId];
      expect([q, word.evidence === "A"]).toEqual([q, ENGLISH_LABELS[q] !== undefined]);
      if (ENGLISH_LABELS[q] !== undefined) expect([q, word.text]).toEqual([q, ENGLISH_LABELS[q]]);
      expect(ncWords("de").params[p.text as ParamTextId].evidence, q).toBe("K2");
    }
    for (const language of NC_LANGUAGES) expect(ncLabels(language).cycleName(number)).not.toBe("");
    const name = ncWords("en").cycles[number as 812];
    expect([name.evidence === "A", NAMED[number] ?? name.text]).toEqual([number === 820 || number in NAMED, name.text]);
    expect(cycle.partly !== undefined).toBe(number in NAMED);
  });
});

describe("the catalogue", () => {
  test("contains each number once, and finds it", () => {
    expect(new Set(catalogue.map((c) => c.number)).size).toBe(catalogue.length);
    for (const cycle of catalogue) expect(cycleByNumber(cycle.number)).toBe(cycle);
    expect(cycleByNumber(7)).toBeUndefined();
  });

  test.each(Object.entries(KINDS))("%s measures %s", (key, kind) => {
    const [number = "", q = ""] = key.split("/");
    expect(cycleByNumber(Number(number))?.params[q]?.kind).toBe(kind);
  });

  test("only Q488 and Q500 may be left out, and only the clearance of recess turning is reserved", () => {
    const all = catalogue.flatMap((c) => Object.entries(c.params).map(([q, p]) => ({ q, group: c.group, p })));
    expect(
      all.filter(({ p }) => p.optional !== p.text.startsWith("plungingFeed") && !p.rounds).map(({ q }) => q),
    ).toEqual([]);
    expect(all.filter(({ p }) => p.rounds && !p.optional).map(({ q }) => q)).toEqual([]);
    for (const { q, group, p } of all) expect([q, p.reserved]).toEqual([q, q === "Q460" && group === "recessTurning"]);
  });

  test("Chinese NC text is English, as the control prints it", () => {
    expect(ncLabels("zh").cycleName(820)).toBe("TURN CONTOUR TRANSV.");
    expect(ncLabels("zh").contour).toMatchObject({ title: "CONTOUR GEOMETRY", label: "CONTOUR LABEL" });
    expect(ncLabels("fr").contour).toMatchObject({ title: "CONTOUR", label: "LABEL CONTOUR" });
    expect(ncLabels("de").contour).toMatchObject({ title: "KONTUR", label: "KONTURLABEL" });
    expect([ncLabels("en").cycleName(1), ncLabels("en").label("constructor")]).toEqual(["", ""]);
  });
});
