import { useState } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import { lazyPart } from "../../base/parts.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** Loaded when first expanded. */
const MoveRows = lazyPart(async () => ({ default: (await import("./MoveRows.tsx")).MoveRows }));

/** All moves in words and numbers, collapsed by default. */
export function MoveTable({ run, playback }: { readonly run: Run; readonly playback: PlaybackStore }) {
  const t = useTexts().lathe;
  const [open, setOpen] = useState(false);
  return (
    <details className="lathe-moves" name="lathe-more" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{t.moves(String(run.steps.length))}</summary>
      {open && run.steps.length > 0 && <MoveRows run={run} playback={playback} />}
    </details>
  );
}
