import { describe, expect, test } from "vitest";
import type { GlossaryTexts, TermId } from "../../src/i18n/glossary-text.ts";
import { LESSON_LANGUAGES, type LessonLanguage } from "../../src/i18n/languages.ts";

/*
 * One word for one thing in each language, wherever a trainee reads it: lessons, tasks, glossary and the app itself.
 * The words are those of the control where it has one.
 */

/** The name in the glossary, and words that must never replace it in that language. */
type OneTerm = readonly [name: string, ...never: RegExp[]];
const TERMS: Partial<Record<TermId, Readonly<Record<LessonLanguage, OneTerm>>>> = {
  block: { en: ["Block"], de: ["Satz"], fr: ["Séquence", /\bblocs?\b/i], zh: ["程序段", /语句|程序句/] },
  setupClearance: {
    en: ["Set-up clearance (Q460)", /safety distance/i],
    de: ["Sicherheitsabstand (Q460)", /Sicherheitshöhe|Sicherheitsdistanz/],
    fr: ["Distance d’approche (Q460)", /distance de sécurité/i],
    zh: ["安全高度（Q460）", /安全距离|安全间隙/],
  },
  theoreticalTip: {
    en: ["Theoretical tip", /imaginary (tip|point)/i],
    de: ["Theoretische Schneidenspitze", /theoretische[nr]? (Spitze|Werkzeugspitze)/i],
    fr: ["Pointe théorique", /pointe imaginaire|bout théorique/i],
    zh: ["理论刀尖", /假想刀尖|虚拟刀尖/],
  },
  cuttingPoint: {
    en: ["Cutting point"],
    de: ["Schneidpunkt", /Schnittpunkt der Schneide|Schneidenpunkt/],
    fr: ["Point de coupe", /point coupant/i],
    zh: ["切削点", /切点/],
  },
  noseRadius: {
    en: ["Tool nose radius (RS)", /tip radius|insert radius of/i],
    de: ["Schneidenradius (RS)", /Plattenradius|Nasenradius|Spitzenradius/],
    fr: ["Rayon de bec (RS)", /rayon de pointe|rayon du nez/i],
    zh: ["刀尖半径（RS）", /刀鼻|刀头半径/],
  },
  startPoint: {
    en: ["Start point", /starting point/i],
    de: ["Startpunkt", /Anfangspunkt|Ausgangspunkt/],
    fr: ["Point de départ", /point de démarrage/i],
    zh: ["起点", /起始点|出发点/],
  },
  infeed: { en: ["Infeed"], de: ["Zustellung"], fr: ["Valeur de passe"], zh: ["进刀量", /进给深度/] },
  oversize: {
    en: ["Oversize"],
    de: ["Aufmaß", /Aufmass\b|Übermaß/],
    fr: ["Surépaisseur", /surcote/i],
    zh: ["余量", /加工裕量|预留量/],
  },
  shoulder: { en: ["Shoulder"], de: ["Absatz", /\bSchulter/], fr: ["Épaulement"], zh: ["台阶", /台肩/] },
  face: { en: ["Face"], de: ["Planfläche", /(?<!mit der |Seite und )\bStirn\b/], fr: ["Face"], zh: ["端面", /平面端/] },
  undercut: {
    en: ["Undercut"],
    de: ["Freistich", /Hinterstich|Unterstich/],
    fr: ["Dégagement"],
    zh: ["退刀槽", /越程槽/],
  },
  runIn: { en: ["Run-in"], de: ["Anlaufweg"], fr: ["Course d’engagement"], zh: ["导入段", /引入段/] },
  limit: {
    en: ["Machining limit"],
    de: ["Schnittbegrenzung"],
    fr: ["Limite d’usinage"],
    zh: ["加工极限", /加工界限/],
  },
  speedLimit: {
    en: ["Speed limit (SMAX)"],
    de: ["Drehzahlbegrenzung (SMAX)", /Drehzahlgrenze/],
    fr: ["Limitation de vitesse (SMAX)"],
    zh: ["转速限制（SMAX）"],
  },
  holder: { en: ["Holder"], de: ["Halter"], fr: ["Porte-outil"], zh: ["刀杆", /刀柄/] },
  residue: {
    en: ["Residual material"],
    de: ["Restmaterial"],
    fr: ["Matière résiduelle", /matière restante/i],
    zh: ["残余材料", /残料/],
  },
  gouge: {
    en: ["Contour damage"],
    de: ["Konturverletzung"],
    fr: ["Violation de contour"],
    zh: ["轮廓损伤"],
  },
  rapid: { en: ["Rapid traverse"], de: ["Eilgang"], fr: ["Avance rapide"], zh: ["快移"] },
  airPass: { en: ["Air pass"], de: ["Luftschnitt"], fr: ["Passe à vide"], zh: ["空走刀"] },
};

/** Words that must not vary and are not in the glossary. */
const NEVER: Readonly<Record<LessonLanguage, readonly RegExp[]>> = {
  en: [],
  // a prompt is an Eingabe; Spanfläche is a tool face, not the chip section, which has one name only
  de: [/\bAbfragen?\b/, /Spanfläche/, /Spanungsquerschnitt/, /aus dem Gedächtnis/],
  fr: [/\binvites?\b/i],
  // the control, the axis
  zh: [/(?<!数)控制系统/, /轴心/],
};

/** Search terms: other words for the same thing are their purpose. */
const SEARCHED = "/shop-words.ts";

const sources = import.meta.glob<string>("../../src/i18n/*/**/*.ts", { eager: true, query: "?raw", import: "default" });
const glossaries = import.meta.glob<GlossaryTexts>("../../src/i18n/*/glossary.ts", { eager: true, import: "glossary" });
const courses = import.meta.glob<{ words: Record<LessonLanguage, unknown> }>(
  "../../src/course/{lessons,tasks}/*.json",
  {
    eager: true,
    import: "default",
  },
);

/** Every text of a language: those of the course, and the files of the app without comments. */
const texts = (language: LessonLanguage): readonly (readonly [where: string, text: string])[] => [
  ...Object.entries(courses).map(([path, { words }]) => [path, JSON.stringify(words[language])] as const),
  ...Object.entries(sources)
    .filter(([path]) => path.includes(`/i18n/${language}/`) && !path.endsWith(SEARCHED))
    .map(([path, text]) => [path, text.replaceAll(/\/\*[^]*?\*\/|\/\/.*$/gm, "")] as const),
];

const found = (language: LessonLanguage, never: RegExp) =>
  texts(language).flatMap(([where, text]) => {
    const at = text.search(never);
    return at < 0 ? [] : [`${where}: …${text.slice(Math.max(at - 30, 0), at + 30)}…`];
  });

describe.each(LESSON_LANGUAGES)("the words of the trade in %s", (language) => {
  const all = texts(language),
    glossary = glossaries[`../../src/i18n/${language}/glossary.ts`];

  test("are searched in lessons, tasks and the app", () => {
    expect(all.filter(([where]) => where.includes("/lessons/")).length).toBeGreaterThan(20);
    expect(all.filter(([where]) => where.includes("/tasks/")).length).toBeGreaterThan(60);
    expect(all.filter(([where]) => where.includes("/i18n/")).length).toBeGreaterThan(30);
  });

  test("are in the glossary as they are used", () => {
    for (const [term, of] of Object.entries(TERMS))
      expect([term, glossary?.[term as TermId].name]).toEqual([term, of[language][0]]);
  });

  test("do not vary", () => {
    const never = Object.values(TERMS).flatMap((of) => of[language].slice(1) as RegExp[]);
    expect([...never, ...NEVER[language]].flatMap((pattern) => found(language, pattern))).toEqual([]);
  });
});
