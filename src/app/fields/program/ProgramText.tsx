import { memo, useEffect, useMemo, useRef } from "react";
import { guardCopy } from "../leaving/whole-program.ts";
import { KEEPS_KEYBOARD } from "../../place/place.ts";
import { printedBlocks } from "../../document/printed.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { foundIn, type PrintedSearchState } from "../find/found-text.tsx";

/** A program line: block number, and the parameter on it. */
export interface ChosenLine {
  readonly block: number;
  readonly q: string | null;
}

const qOfLine = (line = ""): string | null => /^\s*(Q\d+)=/.exec(line)?.[1] ?? null;

/** Scrolls a row into view with the next frame; measuring earlier would force a layout. */
function showWithPicture(frame: HTMLElement | null, which: string): () => void {
  const picture = requestAnimationFrame(() => {
    const row = frame?.querySelector<HTMLElement>(which);
    if (!frame || !row) return;
    const top = row.offsetTop - frame.offsetTop;
    if (top < frame.scrollTop || top + row.offsetHeight > frame.scrollTop + frame.clientHeight)
      frame.scrollTop = Math.max(0, top - frame.clientHeight / 3);
  });
  return () => cancelAnimationFrame(picture);
}

interface BlockProps {
  readonly number: number;
  readonly text: string;
  readonly runs: boolean;
  readonly isChosen: boolean;
  /** The parameter that is chosen in a chosen block. */
  readonly q: string | null;
  readonly sought: string;
  /** Where in its text the shown occurrence begins. */
  readonly shown: number | null;
}

/** Offsets of texts that stand one below the other. */
function startsOf(texts: readonly string[]): readonly number[] {
  let next = 0;
  return texts.map((text) => {
    const start = next;
    next += text.length + 1;
    return start;
  });
}

/** One block, memoised so that only changed ones re-render. */
const Block = memo(function Block({ number, text, runs, isChosen, q, sought, shown }: BlockProps) {
  const t = useTexts().page.text,
    lines = text.split("\n"),
    starts = startsOf(lines);
  return (
    <li
      className={`${runs ? "running" : ""}${isChosen ? " chosen" : ""}`.trim()}
      aria-current={runs ? "step" : undefined}
      data-block={number}
    >
      {lines.map((line, n) => (
        <code key={n} className={isChosen && q === qOfLine(line) ? "chosen-line" : ""}>
          {(sought !== "" && foundIn(line, sought, shown === null ? null : shown - (starts[n] ?? 0))) || line || " "}
        </code>
      ))}
      {runs && <span className="unseen">({t.running})</span>}
    </li>
  );
});

/** The text as the control writes it, one list item per block; the running one is marked and kept in view. */
export function ProgramText({
  text,
  running,
  chosen,
  choose,
  search,
}: {
  readonly text: string;
  readonly running: number | null;
  /** The clicked line. */
  readonly chosen: ChosenLine | null;
  readonly choose: (line: ChosenLine) => void;
  readonly search: PrintedSearchState;
}) {
  const t = useTexts().page.text;
  const blocks = useMemo(() => printedBlocks(text), [text]);
  const starts = useMemo(() => startsOf(blocks.map(({ lines }) => lines.join("\n"))), [blocks]);
  const box = useRef<HTMLDivElement>(null);

  useEffect(() => showWithPicture(box.current, "[aria-current]"), [running]);
  useEffect(() => showWithPicture(box.current, ".chosen-line"), [chosen]);
  useEffect(() => showWithPicture(box.current, ".nc-found.shown"), [search]);

  const press = (pressed: EventTarget) => {
    const line = pressed instanceof Element && pressed.closest("code"),
      block = line && line.closest<HTMLElement>("[data-block]");
    // Selecting text to copy it chooses no line.
    if (!block || getSelection()?.isCollapsed === false) return;
    choose({ block: Number(block.dataset["block"]), q: qOfLine(line.textContent) });
  };
  /** Up and down go from line to line: the lines of a cycle are its parameters. */
  const step = (by: number) => {
    const lines = blocks.flatMap(({ number, lines: all }) =>
      all.map((line): ChosenLine => ({ block: number, q: qOfLine(line) })),
    );
    const at = lines.findIndex((line) => line.block === (chosen?.block ?? running) && line.q === (chosen?.q ?? null));
    const next = lines[Math.min(lines.length - 1, Math.max(0, at + by))];
    if (next) choose(next);
  };

  return (
    <div
      className="program-text number"
      onCopy={(event) => guardCopy(event.nativeEvent, getSelection()?.toString() ?? "")}
      ref={box}
      tabIndex={0}
      role="group"
      aria-label={t.title}
      {...{ [KEEPS_KEYBOARD]: "" }}
      onKeyDown={(event) => {
        if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
        event.preventDefault();
        step(event.key === "ArrowDown" ? 1 : -1);
      }}
    >
      <ol aria-label={t.blocks} onClick={(event) => press(event.target)}>
        {blocks.map(({ number, lines }, i) => {
          const isChosen = number === chosen?.block,
            at = search.shown ? search.shown.from - (starts[i] ?? 0) : -1;
          return (
            <Block
              key={i}
              number={number}
              text={lines.join("\n")}
              runs={number === running}
              isChosen={isChosen}
              q={isChosen ? chosen.q : null}
              sought={search.sought}
              shown={at >= 0 && at < lines.join("\n").length ? at : null}
            />
          );
        })}
      </ol>
    </div>
  );
}
