import { useCallback } from "react";
import type { Ring } from "../../../kernel/geometry/point.ts";
import { boundsOf } from "../../../view/bounds.ts";
import { chuckPatch, patchWithin, turnedPatchOf } from "../../../view/material/changed-box.ts";
import type { ChuckDrawing } from "../../../view/material/chuck.ts";
import type { MaterialColours } from "../../../view/material/paint-target.ts";
import type { Patch } from "../../../view/material/pen.ts";
import { farthest, stockPainter, untouchedRun } from "../../../view/material/stock-painter.ts";
import type { SectionView } from "../../base/settings/settings.ts";
import { pageColours, useTheme } from "../../base/use-theme-colours.ts";
import type { PlayedScene } from "../../calculation/moving.ts";
import { NOWHERE, type PaintedScene } from "./follow-sheet.ts";
import { PaintedSheet } from "./PaintedSheet.tsx";
import { knownOf } from "./played-layer.ts";
import type { Viewport } from "./viewport.ts";

const COLOURS = {
  ground: "--material",
  hatch: "--material-hatch",
  edge: "--steel-edge",
  steelDark: "--steel-dark",
  steel: "--steel",
  steelLight: "--steel-light",
  chuckDark: "--chuck-dark",
  chuck: "--chuck",
  chuckLight: "--chuck-light",
} as const satisfies Record<keyof MaterialColours, string>;

/** Used if nothing is around the workpiece, since a bitmap has at least one pixel. */
const SPECK: Patch = { x: 0, y: 0, width: 1, height: 1 };

/** Turned stock in its section, with the chuck around it. */
export function TurnedSheet({
  viewport,
  moving,
  blank,
  section,
  chuck,
}: {
  readonly viewport: Viewport;
  readonly moving: PlayedScene | null;
  /** The blank before anything moves. */
  readonly blank: readonly Ring[];
  readonly section: SectionView;
  readonly chuck: ChuckDrawing | null;
}) {
  const theme = useTheme();
  const scene = useCallback((): PaintedScene<"lathe"> => {
    const blanks = moving?.blanks ?? blank,
      box = boundsOf(blanks.flat()),
      widest = { outer: farthest(blanks), along: 0 };
    const colours = pageColours(COLOURS);
    return {
      viewport,
      playback: moving?.playback ?? null,
      painter: stockPainter(moving ?? untouchedRun(blank)),
      style: JSON.stringify([theme, section, chuck]),
      known: () => moving && knownOf(moving.steps, "lathe"),
      growing: null,
      look: (view) => ({
        ...view,
        section,
        chuck,
        colours,
        origin: (box && patchWithin(turnedPatchOf(box, view.camera, widest, view.ratio), view.room)) ?? NOWHERE,
        ground: (chuck && patchWithin(chuckPatch(chuck, view.camera, view.ratio), view.room)) ?? SPECK,
      }),
    };
  }, [viewport, moving, blank, section, chuck, theme]);
  return <PaintedSheet scene={scene} />;
}
