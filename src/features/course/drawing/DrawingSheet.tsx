import { useId, useMemo, useRef, type CSSProperties } from "react";
import { createPortal } from "react-dom";
import type { DrawnTask } from "../../../course/drawn-task.ts";
import type { CourseDrawingTexts } from "../../../i18n/en/course-drawing.ts";
import type { PrintWords } from "../../../view/drawing/print-sizes.ts";
import { forMaker } from "../../../view/drawing/maker.ts";
import { drawingOnSheet } from "../../../view/drawing/part-drawing.ts";
import { drawingSvg } from "../../../view/drawing/drawing-svg.ts";
import { downloadText } from "../../../app/base/download.ts";
import { useSize } from "../../../app/pictures/help/use-size.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { PaperDrawing } from "../../../app/pictures/paper/PaperDrawing.tsx";
import { SizeList } from "./SizeList.tsx";
import { sheetTitleOf, type Titled } from "./title-words.ts";
import { TitleBlock } from "./TitleBlock.tsx";
import { useSheetZoom } from "./use-sheet-zoom.ts";

/** Inside of the frame of a landscape sheet, and the part of it above the title block, mm. */
const SHEETS = {
  a4: { width: 277, height: 190, drawing: 158 },
  letter: { width: 259, height: 195, drawing: 163 },
} as const;
/** Pixels per millimetre at which figures are readable; margin around the sheet, pixels. */
const READABLE = 3.4,
  AIR = 24;

interface Props {
  readonly titled: Titled;
  readonly drawn: DrawnTask;
  readonly words: PrintWords;
  readonly t: CourseDrawingTexts;
  /** File name without extension. */
  readonly stem: string;
  readonly onClose: () => void;
}

/** A workshop drawing over the whole page, as the printed sheet: to scale, with its title block. */
export function DrawingSheet({ titled, drawn, words, t, stem, onClose }: Props) {
  const dialog = useRef<HTMLDialogElement>(null),
    frame = useRef<HTMLDivElement>(null);
  const list = useId();
  const paper = useSettings((s) => s.paper);
  const { width, height, drawing } = SHEETS[paper];
  const size = useSize(frame, { width: width * READABLE, height: height * READABLE });
  const fit = Math.min((size.width - AIR) / width, (size.height - AIR) / height);
  const zoom = useSheetZoom(frame, fit, READABLE);
  const print = useMemo(
    () => drawingOnSheet(forMaker(drawn, words), { width: width - 2, height: drawing }),
    [drawn, words, width, drawing],
  );
  if (!print) return null;
  const name = t.drawingOf(titled.name),
    title = sheetTitleOf({ titled, drawn, print, words, t });
  const mm = (value: number) => `calc(${value} * var(--mm))`;
  return createPortal(
    <ModalDialog isBare ref={dialog} className="drawing-dialog" first=".drawing-view" title={name} done={onClose}>
      <div className="drawing-bar">
        <button type="button" className="button" onClick={() => dialog.current?.close()}>
          <Icon name="back" /> <span className="drawing-word">{t.close}</span>
        </button>
        <span className="drawing-zoom">
          <button type="button" className="button icon" aria-label={t.zoomOut} title={t.zoomOut} onClick={zoom.smaller}>
            −
          </button>
          <button type="button" className="button" onClick={zoom.whole}>
            {t.whole}
          </button>
          <button type="button" className="button icon" aria-label={t.zoomIn} title={t.zoomIn} onClick={zoom.larger}>
            +
          </button>
        </span>
        <span className="drawing-zoom">
          <button
            type="button"
            className="button"
            aria-label={t.saveSvg}
            title={t.saveSvg}
            onClick={() => downloadText(drawingSvg(print, title, { width, height }), `${stem}.svg`)}
          >
            <Icon name="download" /> SVG
          </button>
          <button
            type="button"
            className="button primary"
            aria-label={t.print}
            title={t.printHint}
            onClick={() => globalThis.print()}
          >
            <Icon name="print" /> <span className="drawing-word">{t.print}</span>
          </button>
        </span>
      </div>
      <div
        className="drawing-view"
        ref={frame}
        role="region"
        aria-label={t.sheet}
        tabIndex={0}
        onKeyDown={zoom.onKeyDown}
        onDoubleClick={zoom.turn}
      >
        <figure
          className="workshop drawing-page"
          data-paper={paper}
          aria-label={name}
          style={{ "--mm": `${zoom.scale / 16}rem`, width: mm(width), height: mm(height) } as CSSProperties}
        >
          <div className="drawing-field">
            <PaperDrawing
              drawing={print}
              name={name}
              list={list}
              style={{ width: mm(print.width), height: mm(print.height) }}
            />
          </div>
          <figcaption>
            <TitleBlock title={title} />
          </figcaption>
        </figure>
        <SizeList id={list} list={print.list} general={print.general} words={words} t={t} />
      </div>
    </ModalDialog>,
    document.body,
  );
}
