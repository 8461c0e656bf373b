import { useTexts } from "../../base/settings/use-texts.ts";
import { useLengths } from "../../calculation/lengths.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { useMomentTexts } from "./use-moment-texts.ts";

/** The texts about a moment, by the names of their elements (`data-says`). */
export type MomentTexts = Readonly<Record<string, string>>;

/** What a scene says about the shown moment. */
export interface MomentWords {
  /** The cells of the read-out: name of the text, label, and whose width it has. */
  readonly cells: readonly (readonly [says: string, label: string, like?: string])[];
  /** What else is said, in one line: name of the text, and the attributes of its element. */
  readonly notes: readonly (readonly [says: string, look?: { readonly className?: string; readonly title?: string }])[];
  /** The texts of the moment; null in an empty run. */
  readonly texts: () => MomentTexts | null;
  /** The moment in one sentence. */
  readonly sentence: () => string;
}

const textOfCell = (now: MomentTexts | null, says: string): string | null => now?.[says] ?? null;

/** Live position, feed and step, updated without rendering. */
export function Readout({
  playback,
  words: { cells, notes, texts },
}: {
  readonly playback: PlaybackStore;
  readonly words: MomentWords;
}) {
  const t = useTexts().lathe,
    { unit } = useLengths();
  const group = useMomentTexts(playback, texts, textOfCell);
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
      <p className="lathe-phase soft">
        {notes.map(([says, look]) => (
          <span key={says} data-says={says} {...look} />
        ))}
      </p>
    </div>
  );
}
