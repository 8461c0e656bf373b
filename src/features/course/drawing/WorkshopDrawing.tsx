import { useId, useMemo, useRef, useState } from "react";
import { drawnTask } from "../../../course/drawn-task.ts";
import { shownId, type Task } from "../../../course/task.ts";
import type { Language } from "../../../i18n/languages.ts";
import { usualTable } from "../../../program/tools/cutting-table.ts";
import { forMaker } from "../../../view/drawing/maker.ts";
import { partDrawing } from "../../../view/drawing/part-drawing.ts";
import { useSize } from "../../../app/pictures/help/use-size.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { inScreenLanguage } from "../../../course/words.ts";
import { DrawingSheet } from "./DrawingSheet.tsx";
import { PaperDrawing } from "../../../app/pictures/paper/PaperDrawing.tsx";
import { printWords } from "./print-words.ts";
import { SizeList } from "./SizeList.tsx";
import { TitleBlock } from "./TitleBlock.tsx";
import { sheetTitleOf } from "./title-words.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import "./drawing.css";

/** Pixels per millimetre on paper: 3 mm figures are as large as the small text of the page. */
const PIXELS = 4.2;
/** Narrowest and widest paper, and its greatest height, mm. */
const PAPER = { narrow: 84, wide: 178, height: 128 } as const;

/** The drawn parts of a task, and the title for the title block. */
export type DrawableTask = Pick<Task, "id" | "part" | "sizes" | "rules" | "material"> & {
  readonly words: Task["words"];
};

/**
 * The target part of a task as a shop drawing, with title block and list of sizes, and as a separate sheet, large and
 * for printing. In the screen language.
 */
export function WorkshopDrawing({ task, language }: { readonly task: DrawableTask; readonly language: Language }) {
  const t = useTexts("course-drawing");
  const list = useId();
  const [large, setLarge] = useState(false);
  const frame = useRef<HTMLDivElement>(null);
  const { width: room } = useSize(frame, { width: PAPER.wide * PIXELS, height: 0 });
  const width = Math.round(Math.min(PAPER.wide, Math.max(PAPER.narrow, room / PIXELS)));
  const words = useMemo(() => printWords(t, language), [t, language]);
  const drawn = useMemo(() => drawnTask(task), [task]);
  const print = useMemo(
    () => drawn && partDrawing(forMaker(drawn, words), { width, height: PAPER.height }),
    [drawn, words, width],
  );
  const name = inScreenLanguage(task.words, language)?.title ?? task.id;
  if (!drawn || !print) return <p className="soft">{t.none}</p>;
  const titled = {
    name,
    number: shownId(task),
    material: usualTable.materials.find(({ id }) => id === task.material)?.name,
  };
  return (
    <figure className="workshop" aria-label={t.drawingOf(name)}>
      <div className="workshop-bar">
        <button type="button" className="button" onClick={() => setLarge(true)}>
          <Icon name="print" /> {t.large}
        </button>
      </div>
      {/* The drawing itself is clickable; keyboard and screen reader use the button. */}
      <div
        className="workshop-paper"
        ref={frame}
        tabIndex={print.width > width ? 0 : -1}
        onClick={() => setLarge(true)}
      >
        <PaperDrawing
          drawing={print}
          name={t.drawingOf(name)}
          list={list}
          style={{ width: `${(print.width / width) * 100}%` }}
        />
      </div>
      <figcaption>
        <TitleBlock title={sheetTitleOf({ titled, drawn, print, words, t })} />
        <SizeList id={list} list={print.list} general={print.general} words={words} t={t} />
      </figcaption>
      {large && (
        <DrawingSheet
          titled={titled}
          drawn={drawn}
          words={words}
          t={t}
          stem={shownId(task)}
          onClose={() => setLarge(false)}
        />
      )}
    </figure>
  );
}
