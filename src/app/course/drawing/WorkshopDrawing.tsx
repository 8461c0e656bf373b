import { useId, useMemo, useRef } from "react";
import { drawnTask } from "../../../course/printed-part.ts";
import type { Task } from "../../../course/task.ts";
import { loadCourseDrawing } from "../../../i18n/load-course-drawing.ts";
import type { Language } from "../../../i18n/languages.ts";
import { boundsOf } from "../../../view/bounds.ts";
import { NEXT, nominalWidth, SMALL, widthOf, type PrintText } from "../../../view/drawing/paper.ts";
import { workshopDrawing } from "../../../view/drawing/workshop-drawing.ts";
import { FIGURES } from "../../../view/sheet/sizes.ts";
import { toDiameter, radius } from "../../../kernel/units.ts";
import { useSize } from "../../help/use-size.ts";
import { laterTexts } from "../../settings/later-texts.ts";
import { inScreenLanguage } from "../content.ts";
import { printWords } from "./print-words.ts";
import { SizeList } from "./SizeList.tsx";
import "./drawing.css";

const { useThem: useDrawingTexts } = laterTexts(loadCourseDrawing);

/** Pixels for a millimetre on paper: figures of 3 mm are as large as the small text of the page. */
const PIXELS = 4.2;
/** Narrowest and widest paper, and its greatest height, mm. */
const PAPER = { narrow: 84, wide: 178, height: 128 } as const;

/** How far deviations stand above and below the middle of their nominal, mm on paper. */
const STACKED = 1.25;

/** What is drawn of a task, and the name that stands in its title block. */
export type DrawableTask = Pick<Task, "id" | "part" | "sizes" | "rules"> & { readonly words: Task["words"] };

/** The wanted part of a task as on a shop print, with its title block and its sizes as a list. Language: that of the screen. */
export function WorkshopDrawing({ task, language }: { readonly task: DrawableTask; readonly language: Language }) {
  const t = useDrawingTexts();
  const hatch = useId(), list = useId();
  const frame = useRef<HTMLDivElement>(null);
  const { width: room } = useSize(frame, { width: PAPER.wide * PIXELS, height: 0 });
  const width = Math.round(Math.min(PAPER.wide, Math.max(PAPER.narrow, room / PIXELS)));
  const words = useMemo(() => printWords(t, language), [t, language]);
  const drawn = useMemo(() => drawnTask(task), [task]);
  const print = useMemo(() => drawn && workshopDrawing(drawn, words, { width, height: PAPER.height }), [drawn, words, width]);
  const name = inScreenLanguage(task.words, language)?.title ?? task.id;
  if (!drawn || !print) return <p className="soft">{t.none}</p>;
  const blank = boundsOf(drawn.blank.flat());
  const across = (r: number) => words.diameter(toDiameter(radius(r)));
  const facts: readonly (readonly [keyof typeof t.head, string])[] = [
    ["number", task.id],
    ["scale", t.scale(print.scale.paper, print.scale.part)],
    ...(blank
      ? [
        [
          "blank",
          [
            t.blankOf(across(blank.high), blank.low > 0 ? across(blank.low) : "", words.length(blank.right - blank.left)),
            ...(blank.right > 0 ? [t.allowance(words.length(blank.right))] : []),
          ].join(", "),
        ] as const,
      ]
      : []),
    ["material", t.steel],
    ["unit", t.inMm],
    ["general", t.tolerances],
    ...(print.general === null ? [] : [["surface", print.general] as const]),
  ];
  const notes = [
    t.tolerancesHint,
    ...(print.list.some(({ kind }) => kind === "blank") ? [t.brackets] : []),
    ...(print.left > 0 ? [t.leftOut(print.left)] : []),
  ];
  return (
    <figure className="workshop" aria-label={t.drawingOf(name)}>
      <div className="workshop-paper" ref={frame} tabIndex={print.width > width ? 0 : -1}>
        <svg role="img" aria-label={t.drawingOf(name)} aria-describedby={list} viewBox={`0 0 ${print.width} ${print.height}`}
          style={{ width: `${(print.width / width) * 100}%` }}
        >
          <pattern id={hatch} width="1.8" height="1.8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
            <path d="M0 0V1.8" className="workshop-hatch" />
          </pattern>
          {print.shapes.map(({ role, d }, i) => (
            <path key={i} className={`workshop-${role}`} d={d} {...(role === "section" && { fill: `url(#${hatch})` })} />
          ))}
          {print.texts.map((text, i) => <Written key={i} text={text} />)}
        </svg>
      </div>
      <figcaption>
        <dl className="workshop-title">
          <div className="workshop-name">
            <dt>{t.head.name}</dt>
            <dd>{name}</dd>
          </div>
          {facts.map(([fact, value]) => (
            <div key={fact}>
              <dt>{t.head[fact]}</dt>
              <dd>{value}</dd>
            </div>
          ))}
        </dl>
        <p className="workshop-notes">{notes.join(" · ")}</p>
        <SizeList id={list} list={print.list} general={print.general} words={words} t={t} />
      </figcaption>
    </figure>
  );
}

/** A size with its deviations, as a print stacks them. */
function Written({ text }: { readonly text: PrintText }) {
  const { at: { x, y }, turned } = text;
  const start = x - widthOf(text) / 2, next = start + nominalWidth(text) + NEXT;
  return (
    <g className="workshop-figure" {...(turned && { transform: `rotate(-90 ${x} ${y})` })}>
      <text x={start} y={y} fontSize={FIGURES}>{text.text}</text>
      {text.upper !== undefined && <text x={next} y={y - STACKED} fontSize={FIGURES * SMALL}>{text.upper}</text>}
      {text.lower !== undefined && <text x={next} y={y + STACKED} fontSize={FIGURES * SMALL}>{text.lower}</text>}
    </g>
  );
}
