import { useEffect, useState } from "react";

/** True once something has gone on for a while, ms. */
export function useLong(goesOn: boolean, after: number): boolean {
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
