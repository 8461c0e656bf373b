import type { ReactNode } from "react";
import type { SheetTexts } from "../../i18n/en/sheet.ts";
import type { ClampingTexts } from "../../i18n/en/clamping.ts";
import type { Clamping } from "../../kernel/area/clamping.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { boundsOf } from "../../view/bounds.ts";
import { missingFiles } from "../../app/calculation/missing-files.ts";
import { filesOf, type ProgramWork } from "../../app/document/work.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import type { SheetWords } from "./sheet-words.ts";
import type { SheetSource } from "./use-sheet.ts";

/** A line for handwriting. */
const BLANK_LINE = <span className="sheet-line" />;

function zeroText(t: SheetTexts["facts"], words: SheetWords, front: number): string {
  if (Math.abs(front) < SAME) return t.zeroAt;
  return words.units(front > 0 ? t.zeroBehind(words.length(front)) : t.zeroBefore(words.length(-front)));
}

/** The clamping in the words of its fields, one per line. */
function clampingLines(c: Clamping, t: ClampingTexts, words: SheetWords): readonly string[] {
  // Names of diameters already contain their sign.
  const across = words.length,
    along = words.signed,
    said = (name: string, value: string) => [`${name} ${value}`];
  const { tailstock, limit, size } = c;
  return [
    t.kinds[c.kind],
    ...said(t.grips[c.kind], across(c.diameter)),
    ...(c.length > 0 ? said(t.words.LENGTH, words.length(c.length)) : []),
    ...said(t.words.FACE, along(c.face)),
    ...(size === undefined ? [] : said(c.kind === "collet" ? t.nose : t.words.SIZE, across(size))),
    ...(tailstock ? [...said(t.words.QUILL, across(tailstock.quill)), ...said(t.words.TIP, along(tailstock.tip))] : []),
    ...(limit?.z === undefined ? [] : said(t.words.LIMITZ, along(limit.z))),
    ...(limit?.x === undefined ? [] : said(t.words.LIMITX, across(limit.x))),
  ];
}

/** The facts for the setter next to the drawing. */
export function SheetFacts({
  source: { data, outcome },
  work,
  t,
  words,
  comma,
}: {
  readonly source: SheetSource;
  readonly work: ProgramWork | null;
  readonly t: SheetTexts["facts"];
  readonly words: SheetWords;
  readonly comma: string;
}) {
  const run = outcome?.run ?? null,
    clamping = useTextsOrNull("clamping"),
    held = run?.clamping?.clamping;
  const box = run ? boundsOf(run.blank.flat()) : null;
  const cuts = run ? boundsOf(run.steps.filter(({ move }) => move.kind !== "rapid").map(({ move }) => move.to)) : null;
  const limits = data.operations
    .flatMap(({ spindle }) => (spindle ? [spindle.kind === "surface" ? spindle.limit : spindle.speed] : []))
    .filter((speed) => speed > 0);
  const missing = work ? missingFiles(work, outcome) : [];
  const files = [...new Set([...(work ? filesOf(work).map(({ name }) => name) : []), ...data.files])].filter(
    (name) => !missing.includes(name),
  );
  const bore = box && box.low > SAME ? `, ${t.bore} ${words.diameter(toDiameter(radius(box.low)))}` : "";
  const facts: readonly (readonly [string, ReactNode])[] = [
    [
      t.blank,
      box
        ? `${words.diameter(toDiameter(radius(box.high)))} × ${words.length(box.right - box.left)}${bore}`
        : data.box
          ? data.box.map((size) => words.length(size)).join(" × ")
          : t.noBlank,
    ],
    ...(box && box.right > SAME ? [[t.front, words.units(`${words.length(box.right)} mm`)] as const] : []),
    [t.zero, box ? zeroText(t, words, box.right) : t.asMachine],
    [t.preset, data.presets.length > 0 ? t.presets(data.presets.join(comma)) : t.asMachine],
    [t.shift, data.shifts.length > 0 ? data.shifts.map(words.start).join(comma) : t.noShift],
    ...(cuts ? [[t.reach, `Z${words.signed(cuts.left)}`] as const] : []),
    held && clamping
      ? [
          clamping.title,
          clampingLines(held, clamping, words).map((each) => <span key={each}>{words.units(each)}</span>),
        ]
      : [t.clamping, BLANK_LINE],
    [t.pressure, BLANK_LINE],
    ...(limits.length > 0 ? [[t.speed, words.most(Math.max(...limits))] as const] : []),
    [t.changes, String(data.toolChanges)],
    ...(files.length + missing.length > 0
      ? [[t.files, [...files, ...missing.map((name) => `${name} (${t.missing})`)].join(comma)] as const]
      : []),
    ...(data.unknownCycles.length > 0
      ? [[t.cycles, data.unknownCycles.map((n) => t.cycle(String(n))).join(comma)] as const]
      : []),
    ...(outcome?.marked ? [[t.skipped, work?.skipMarked ? t.leftOutBlocks : t.runBlocks] as const] : []),
  ];
  return (
    <dl className="sheet-facts">
      {facts.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
