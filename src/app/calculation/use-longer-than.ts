import { useEffect, useState } from "react";

/** True once `continuesStep` has been true for `after` ms. */
export function useLongerThan(goesOn: boolean, after: number): boolean {
  const [long, setLong] = useState(false);
  useEffect(() => {
    if (!goesOn) return undefined;
    const timer = setTimeout(() => setLong(true), after);
    return () => {
      clearTimeout(timer);
      setLong(false);
    };
  }, [goesOn, after]);
  return long;
}
