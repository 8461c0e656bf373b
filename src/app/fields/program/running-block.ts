import { useOutcome } from "../../calculation/outcome.ts";
import { useReadPlayback } from "../../pictures/lathe/use-playback.ts";
import { playback } from "../../calculation/playback.ts";

/** Number of the block whose move stands at the playback's position; null before and after the run. */
export function useRunningBlock(): number | null {
  const shown = useOutcome((s) => s.pictured);
  return useReadPlayback(playback, (store) => {
    const { position } = store.get();
    if (position.step === 0 && position.fraction === 0) return null;
    return shown?.run.steps[position.step]?.block ?? null;
  });
}
