import { useEffect, useId, useMemo, useRef, useState } from "react";
import { createPortal } from "react-dom";
import { drawnTask } from "../../../course/drawn-task.ts";
import { shownId } from "../../../course/task.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { usualTable } from "../../../program/tools/cutting-table.ts";
import { forMaker } from "../../../view/drawing/maker.ts";
import { partDrawing } from "../../../view/drawing/part-drawing.ts";
import type { ListedSize } from "../../../view/drawing/print-sizes.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { fillDrawingDock, useDrawingDock } from "../../../app/fields/dialog/help-dock.ts";
import { Glyph } from "../../../app/pictures/lathe/Glyph.tsx";
import { useSize } from "../../../app/pictures/help/use-size.ts";
import { KEEPS_KEYBOARD } from "../../../app/place/place.ts";
import { DrawingSheet } from "./DrawingSheet.tsx";
import { LinkedPrint } from "./LinkedPrint.tsx";
import { printWords } from "./print-words.ts";
import { SizeList } from "./SizeList.tsx";
import { useSheetZoom } from "./use-sheet-zoom.ts";
import { useSizeLinks } from "./use-size-links.ts";
import type { DrawableTask } from "./WorkshopDrawing.tsx";
import "./drawing.css";

/** Pixels per millimetre on paper at which figures are easily read, and at least. */
const READABLE = 4.2,
  LEAST = 3.2;
/** Narrowest and widest paper, mm; margin around it, pixels. */
const PAPER = { narrow: 84, wide: 178 } as const;
const AIR = 8;

/** The drawing of a task as a second picture of the workplace; its sizes lead to what makes them, and back. */
export function DrawingPane({ task }: { readonly task: DrawableTask }) {
  const dock = useDrawingDock((d) => d.dock);
  useEffect(() => (dock ? fillDrawingDock() : undefined), [dock]);
  return dock && createPortal(<Pane task={task} />, dock);
}

const NO_SIZES: readonly ListedSize[] = [];

function Pane({ task }: { readonly task: DrawableTask }) {
  const t = useTexts("course-drawing");
  const language = useSettings((s) => s.language);
  const frame = useRef<HTMLDivElement>(null);
  const list = useId();
  const [large, setLarge] = useState(false);
  const [chosen, choose] = useState<number | null>(null);
  const words = useMemo(() => printWords(t, language), [t, language]);
  const drawn = useMemo(() => drawnTask(task), [task]);
  const size = useSize(frame, { width: 640, height: 400 });
  const [width, height] = [size.width - AIR, size.height - AIR];
  const paper = Math.round(Math.min(PAPER.wide, Math.max(PAPER.narrow, width / READABLE)));
  const print = useMemo(
    () =>
      drawn &&
      partDrawing(forMaker(drawn, words), {
        width: paper,
        height: Math.max(PAPER.narrow, height / READABLE),
        fills: true,
      }),
    [drawn, words, paper, height],
  );
  const whole = print ? Math.min(width / print.width, height / print.height) : 1;
  const zoom = useSheetZoom(frame, whole, READABLE, Math.max(whole, print ? Math.min(LEAST, width / print.width) : 1));
  const links = useSizeLinks(print?.list ?? NO_SIZES, t);
  const title = inScreenLanguage(task.words, language)?.title ?? task.id;
  const name = t.drawingOf(title);
  if (!drawn || !print) return <p className="drawing-pane-said soft">{t.none}</p>;
  const shown = chosen === null ? undefined : print.list[chosen];
  const marked = new Set(chosen === null ? links.marked : [...links.marked, chosen]);
  return (
    <section className="drawing-pane" aria-label={name}>
      <div
        className="drawing-view"
        ref={frame}
        role="region"
        aria-label={t.sheet}
        tabIndex={0}
        {...{ [KEEPS_KEYBOARD]: "" }}
        onKeyDown={zoom.onKeyDown}
        onDoubleClick={zoom.turn}
      >
        <LinkedPrint
          print={print}
          name={t.sizesOf}
          outlines={[drawn.outside, drawn.bore]}
          marked={marked}
          nameOf={links.say}
          onChoose={(index, byKey) => {
            choose(index);
            const feature = print.list[index]?.measures;
            if (feature) links.show(feature, !byKey);
          }}
          style={{ width: `${(print.width * zoom.scale) / 16}rem`, height: `${(print.height * zoom.scale) / 16}rem` }}
        />
        {print.omitted > 0 && <SizeList id={list} list={print.list} general={print.general} words={words} t={t} />}
      </div>
      <div className="drawing-pane-bar">
        <p className="drawing-pane-said small" role="status">
          {shown ? links.say(shown) : <span className="soft">{t.chooseSize}</span>}
        </p>
        <button type="button" className="button icon" aria-label={t.zoomOut} title={t.zoomOut} onClick={zoom.smaller}>
          −
        </button>
        <button type="button" className="button icon" aria-label={t.whole} title={t.whole} onClick={zoom.whole}>
          <Glyph name="fit" />
        </button>
        <button type="button" className="button icon" aria-label={t.zoomIn} title={t.zoomIn} onClick={zoom.larger}>
          +
        </button>
        <button
          type="button"
          className="button icon"
          aria-label={t.large}
          title={t.large}
          onClick={() => setLarge(true)}
        >
          <Icon name="print" />
        </button>
      </div>
      {large && (
        <DrawingSheet
          titled={{
            name: title,
            number: shownId(task),
            material: usualTable.materials.find(({ id }) => id === task.material)?.name,
          }}
          drawn={drawn}
          words={words}
          t={t}
          stem={shownId(task)}
          onClose={() => setLarge(false)}
        />
      )}
    </section>
  );
}
