import type { CSSProperties, ReactNode } from "react";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import type { MeasureSource } from "../measure/source.ts";
import { Axes } from "./Axes.tsx";
import { Hovered, type Hover } from "./Chosen.tsx";
import { RunningMove } from "./RunningMove.tsx";
import { useViewBox } from "./use-view-box.ts";
import type { Viewport } from "./viewport.ts";
import { World } from "./World.tsx";

/** The moves of a picture, of which the running one stands out, and the one under the pointer. */
export interface PlayedMoves<Move extends object> {
  readonly moves: readonly Move[];
  readonly playback: PlaybackStore;
  readonly hover?: Hover | undefined;
  /** Path data of a move, in part space. */
  readonly dataOf: (move: Move) => string;
  /** The running one changes with every frame, or no faster than it can be read. */
  readonly each?: "frame" | "reading";
}

/**
 * A plane of the machine, in layers from back to front: grid, material, drawing, tool, texts. The drawing is painted
 * once, however long the path. During playback only the material near the tool is painted, and the layer of the tool
 * moves.
 */
export function FlatPicture<Move extends object>({
  viewport,
  plane,
  name,
  className = "",
  material,
  under,
  defs,
  style,
  drawing,
  tool,
  played,
  children,
}: {
  readonly viewport: Viewport;
  readonly plane: MeasureSource["plane"];
  readonly name: string;
  readonly className?: string;
  /** The painted stock. */
  readonly material: ReactNode;
  /** In part space, behind the drawing. */
  readonly under?: ReactNode;
  /** Patterns of the drawing, and its variables. */
  readonly defs?: ReactNode;
  readonly style?: CSSProperties | undefined;
  /** In part space. */
  readonly drawing: ReactNode;
  readonly tool: ReactNode;
  /** Null before anything moves. */
  readonly played: PlayedMoves<Move> | null;
  /** Content in screen space over the picture. */
  readonly children: ReactNode;
}) {
  const viewBox = useViewBox(viewport);
  return (
    <div className={`lathe-picture ${className}`.trim()} role="img" aria-label={name}>
      <svg className="sheet" viewBox={viewBox}>
        <Axes viewport={viewport} plane={plane} part="grid" />
      </svg>
      {material}
      {under && (
        <svg className="sheet ghosts" viewBox={viewBox}>
          <World viewport={viewport} shifts>
            {under}
          </World>
        </svg>
      )}
      <svg className="sheet still" viewBox={viewBox} style={style}>
        {defs}
        <World viewport={viewport} shifts>
          {drawing}
        </World>
      </svg>
      {tool}
      <svg className="sheet" viewBox={viewBox}>
        <World viewport={viewport}>
          {played?.hover && <Hovered {...played} hover={played.hover} />}
          {played && <RunningMove {...played} />}
        </World>
        {children}
        <Axes viewport={viewport} plane={plane} part="scales" />
      </svg>
    </div>
  );
}
