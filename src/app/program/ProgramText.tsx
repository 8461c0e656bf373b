import { useEffect, useMemo, useRef } from "react";
import { guardCopy } from "../leaving/whole-program.ts";
import { useTexts } from "../settings/use-texts.ts";

/** One block of the program: its number and its lines. */
interface Shown {
  readonly number: number | null;
  readonly lines: readonly string[];
}

/** Lines belong to the numbered line before them: a cycle keeps one number for all its lines. */
export function blocksOf(text: string): readonly Shown[] {
  const blocks: { number: number | null; lines: string[] }[] = [];
  for (const line of text.replace(/\n$/, "").split(/\r?\n/)) {
    const number = /^(\d+)\s/.exec(line);
    const open = blocks.at(-1);
    if (number || !open) blocks.push({ number: number ? Number(number[1]) : null, lines: [line] });
    else open.lines.push(line);
  }
  return blocks;
}

/** The text as the control writes it, one list item a block; the running one is marked and kept in sight. */
export function ProgramText({ text, running }: { readonly text: string; readonly running: number | null }) {
  const t = useTexts().page.text;
  const blocks = useMemo(() => blocksOf(text), [text]);
  const box = useRef<HTMLDivElement>(null);

  useEffect(() => {
    const frame = box.current;
    const row = frame?.querySelector<HTMLElement>("[aria-current]");
    if (!frame || !row) return;
    const top = row.offsetTop - frame.offsetTop;
    if (top < frame.scrollTop || top + row.offsetHeight > frame.scrollTop + frame.clientHeight)
      frame.scrollTop = Math.max(0, top - frame.clientHeight / 3);
  }, [running]);

  return (
    <div className="program-text number" onCopy={(event) => guardCopy(event.nativeEvent, getSelection()?.toString() ?? "")} ref={box}
      tabIndex={0} role="group" aria-label={t.title}
    >
      <ol aria-label={t.blocks}>
        {blocks.map((block, i) => {
          const runs = block.number !== null && block.number === running;
          return (
            <li key={i} className={runs ? "running" : ""} aria-current={runs ? "step" : undefined}
              {...(block.number !== null ? { "data-block": block.number } : {})}
            >
              {block.lines.map((line, n) => <code key={n}>{line || " "}</code>)}
              {runs && <span className="unseen">({t.running})</span>}
            </li>
          );
        })}
      </ol>
    </div>
  );
}
