import type { ReactNode } from "react";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useLengths } from "../../calculation/lengths.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { useMomentTexts } from "./use-moment-texts.ts";

/** The texts about a moment, by the names of their elements (`data-says`). */
export type MomentTexts = Readonly<Record<string, string>>;

const textOfCell = (now: MomentTexts | null, says: string): string | null => now?.[says] ?? null;

/** The cells of a read-out: name of the text, label, and whose width it has. */
export type ReadoutCells = readonly (readonly [says: string, label: string, like?: string])[];

/** Live position, feed and step, updated without rendering. `children`: what else the moment says, in one line. */
export function Readout({
  playback,
  moment,
  cells,
  children,
}: {
  readonly playback: PlaybackStore;
  readonly moment: () => MomentTexts | null;
  readonly cells: ReadoutCells;
  readonly children: ReactNode;
}) {
  const t = useTexts().lathe,
    { unit } = useLengths();
  const group = useMomentTexts(playback, moment, textOfCell);
  return (
    <div ref={group} className="lathe-readout" data-counts={unit} role="group" aria-label={t.now}>
      <dl className="number">
        {cells.map(([says, label, like = says]) => (
          <div key={says} className={`readout-${like}`}>
            <dt>{label}</dt>
            <dd data-says={says} />
          </div>
        ))}
      </dl>
      <p className="lathe-step" data-says="step" />
      <p className="lathe-phase soft">{children}</p>
    </div>
  );
}
