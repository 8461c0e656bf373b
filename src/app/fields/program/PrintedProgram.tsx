import { useEffect, useState } from "react";
import { flushSync } from "react-dom";
import { printedText } from "../../document/printed.ts";
import { handOver, useEditor } from "../../document/store.ts";
import { useIsoFile } from "../../document/output.ts";

/** Widest picture on paper, px of CSS: what A4 and Letter have between their margins. */
const PAPER = 690;

/** A picture keeps the size that it was drawn for; a wider one is made to fit. */
function fixPictures(): void {
  for (const stage of document.querySelectorAll<HTMLElement>(".lathe-stage, .plane-stage")) {
    const { width, height } = stage.getBoundingClientRect();
    if (width === 0) continue;
    stage.style.setProperty("--print-width", `${width}px`);
    stage.style.setProperty("--print-height", `${height}px`);
    stage.style.setProperty("--print-zoom", String(Math.min(1, PAPER / width)));
  }
}

function present(iso: string | null): string {
  handOver();
  const { job, program } = useEditor.getState();
  if (job) return iso ?? printedText(job);
  return program?.text ?? "";
}

/** The whole program for a print of the workplace, whose text scrolls, folds away, or stands in another section. */
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
