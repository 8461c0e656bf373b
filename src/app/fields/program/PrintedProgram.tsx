import { useEffect, useState } from "react";
import { flushSync } from "react-dom";
import { pageLength, pageUnit } from "../../base/unit.ts";
import { openText } from "../../document/printed.ts";
import { flushEdits, useEditor } from "../../document/store.ts";
import { useIsoFile } from "../../document/output.ts";

/** Widest picture on paper, units of the page: fits between the margins of A4 and Letter. */
const PAPER = 690;

/** Pictures keep the size they were drawn for, in units of the page; wider ones are scaled to fit. */
function fixPictures(): void {
  const unit = pageUnit();
  for (const stage of document.querySelectorAll<HTMLElement>(".lathe-stage, .plane-stage")) {
    const box = stage.getBoundingClientRect(),
      width = box.width / unit;
    if (width === 0) continue;
    stage.style.setProperty("--print-width", pageLength(width));
    stage.style.setProperty("--print-height", pageLength(box.height / unit));
    stage.style.setProperty("--print-zoom", String(Math.min(1, PAPER / width)));
  }
}

function present(iso: string | null): string {
  flushEdits();
  return iso ?? openText() ?? "";
}

/** The whole program for printing, since the workplace may scroll or hide its text. */
export function PrintedProgram() {
  const [text, take] = useState<string | null>(null);
  const iso = useIsoFile(useEditor((s) => s.job))?.text ?? null;
  useEffect(() => {
    const begin = () => {
      fixPictures();
      flushSync(() => take(present(iso)));
    };
    const end = () => take(null);
    addEventListener("beforeprint", begin);
    addEventListener("afterprint", end);
    return () => {
      removeEventListener("beforeprint", begin);
      removeEventListener("afterprint", end);
    };
  }, [iso]);
  return text === null ? null : <pre className="printed-program number">{text}</pre>;
}
