import { useEffect, useRef } from "react";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/**
 * The running move, highlighted without rendering; the last one at the end. `dataOf`: path data of a move. `each`: with
 * every frame, or no faster than it can be read.
 */
export function RunningMove<Move extends object>({
  moves,
  playback,
  dataOf,
  each = "frame",
}: {
  readonly moves: readonly Move[];
  readonly playback: PlaybackStore;
  readonly dataOf: (move: Move) => string;
  readonly each?: "frame" | "reading";
}) {
  const running = useRef<SVGPathElement>(null),
    drawn = useRef<Move | null>(null);
  useEffect(() => {
    const paint = () => {
      const move = moves[Math.min(playback.shown().step, moves.length - 1)];
      if (!move || drawn.current === move) return;
      running.current?.setAttribute("d", dataOf(move));
      drawn.current = move;
    };
    paint();
    return each === "frame" ? playback.subscribe(paint) : playback.subscribeReader(paint);
  }, [moves, playback, dataOf, each]);
  return <path ref={running} className="shape-running" />;
}
