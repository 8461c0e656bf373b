import { useTexts } from "../base/settings/use-texts.ts";
import { ANNOUNCED } from "../base/waits.ts";
import { useOutcome } from "./outcome.ts";
import { useLong } from "./use-long.ts";
import "./checking.css";

/** Whether the worker is still at what is shown, and whether for so long that it is to be seen. */
export function useChecking(): { readonly now: boolean; readonly seen: boolean } {
  const now = useOutcome((s) => s.stage !== null);
  return { now, seen: useLong(now, ANNOUNCED.checking) && now };
}

/** Beside a verdict that is not yet that of the present values. It takes no room of its own, so that nothing moves. */
export function Checking() {
  const { checking } = useTexts().lathe;
  return <span className="checking" role="img" aria-label={checking} title={checking} />;
}
