import type { ReactNode } from "react";
import { ANNOUNCE_AFTER } from "../base/waits.ts";
import { useLongerThan } from "./use-longer-than.ts";

/** Says what is waited for, once that takes longer than it takes to read it. */
export function LongWait({
  className = "soft",
  children,
}: {
  readonly className?: string;
  readonly children: ReactNode;
}) {
  const isLong = useLongerThan(true, ANNOUNCE_AFTER.working);
  return isLong ? (
    <p className={className} role="status">
      {children}
    </p>
  ) : null;
}
