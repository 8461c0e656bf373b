import { useEffect, useMemo, useRef } from "react";
import { blocksOfLines } from "../../course/task-start.ts";
import type { Run } from "../../program/state/run-types.ts";
import { Icon } from "../../app/base/Icon.tsx";
import type { PlaybackStore } from "../../app/calculation/playback-store.ts";
import { useReadPlayback } from "../../app/pictures/lathe/use-playback.ts";
import { openLessonExample } from "./open-example.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The program of the picture, with the current block, to read and to open in the editor. */
export function LessonProgram({
  lines,
  run,
  playback,
  open,
  onOpen,
  onPress,
}: {
  readonly lines: readonly string[];
  /** Its run; null while pending. */
  readonly run: Run | null;
  readonly playback: PlaybackStore;
  /** Kept from page to page. */
  readonly open: boolean;
  readonly onOpen: (open: boolean) => void;
  /** A question asks for a block: pressing one answers it, by its number. */
  readonly onPress: ((block: number) => void) | null;
}) {
  const t = useTexts("course").picture;
  const blocks = useMemo(() => blocksOfLines(lines), [lines]);
  const running = useReadPlayback(playback, (store) => run?.steps[store.get().position.step]?.block ?? null);
  const list = useRef<HTMLPreElement>(null);
  useEffect(() => {
    const line = list.current?.querySelector<HTMLElement>("[data-running]");
    if (!list.current || !line) return;
    const over = line.offsetTop - list.current.offsetTop,
      { scrollTop, clientHeight } = list.current;
    if (over < scrollTop || over + line.offsetHeight > scrollTop + clientHeight)
      list.current.scrollTop = over - clientHeight / 2;
  }, [running]);
  return (
    <details
      className="lesson-program"
      open={open}
      onToggle={({ currentTarget: box }) => {
        if (box.open && !open) box.scrollIntoView({ block: "nearest" });
        onOpen(box.open);
      }}
    >
      <summary>{t.program}</summary>
      <pre ref={list} className="number" role="group" tabIndex={0} aria-label={t.program}>
        {blocks.map((block, i) => {
          const shown = { className: "lesson-block", "data-running": i === running ? true : undefined };
          const number = onPress && /^\s*(\d+)/.exec(block)?.[1];
          return onPress && number ? (
            <button key={i} type="button" {...shown} onClick={() => onPress(Number(number))}>
              {block.trimEnd()}
            </button>
          ) : (
            <span key={i} {...shown}>
              {block}
            </span>
          );
        })}
      </pre>
      <button type="button" className="button" onClick={() => openLessonExample(lines)}>
        <Icon name="rename" /> {t.openProgram}
      </button>
    </details>
  );
}
