import { useState } from "react";
import { isOnlySign } from "./number-entry.ts";

/** A sign that was just typed begins a number: what is wrong with it is said once the field is left. */
export function useBegunSign(text: string): {
  /** The text is only a sign, and its field was not left since. */
  readonly isBegun: boolean;
  readonly onTyped: (text: string) => void;
  readonly onLeft: () => void;
} {
  const [begun, begin] = useState<string | null>(null);
  return {
    isBegun: begun === text,
    onTyped: (typed) => begin(isOnlySign(typed) ? typed : null),
    onLeft: () => begin(null),
  };
}
