import { useTexts } from "../base/settings/use-texts.ts";
import { ANNOUNCE_AFTER } from "../base/waits.ts";
import { useOutcome } from "./outcome.ts";
import { useLongerThan } from "./use-longer-than.ts";
import "./checking.css";

/** Whether the shown result is still being checked, and whether for so long that a mark is shown. */
export function useChecking(): { readonly now: boolean; readonly seen: boolean } {
  const now = useOutcome((s) => s.stage !== null);
  return { now, seen: useLongerThan(now, ANNOUNCE_AFTER.checking) && now };
}

/** Mark beside a verdict that is not yet of the present values. It takes no room, so that nothing moves. */
export function Checking() {
  const { checking } = useTexts().lathe;
  return <span className="checking" role="img" aria-label={checking} title={checking} />;
}
