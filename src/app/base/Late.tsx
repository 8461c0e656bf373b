import { useEffect, useState, type ReactNode } from "react";
import { afterPicture } from "./after-picture.ts";

/**
 * The value as it stood when the last picture was painted: it follows a moment after a key, whose picture does not wait
 * for it.
 */
export function useLater<T>(value: T): T {
  const [late, follow] = useState({ value });
  const isLate = !Object.is(late.value, value);
  useEffect(() => (isLate ? afterPicture(() => follow({ value })) : undefined), [isLate, value]);
  return late.value;
}

/**
 * What may come a moment after a key, when the path is drawn: what it shows of the work is that of before until then.
 * Nothing that is typed into belongs here, a field shows its key at once.
 */
export const Late = ({ children }: { readonly children: ReactNode }): ReactNode => useLater(children);
