import { useEffect, useState } from "react";

/** What was made for a page last, and whether it is being made again from what has changed since. */
export interface MadeForPage<T> {
  /** Undefined until it was made once for this page, null where it cannot be made. */
  readonly made: T | null | undefined;
  readonly working: boolean;
}

/**
 * Makes something for a page, `of` which it is, again whenever `source` changes; what was made before stays until then.
 */
export function useMade<T>(
  of: string,
  source: string,
  make: (goesOn: () => boolean) => Promise<T | null>,
): MadeForPage<T> {
  const [last, put] = useState<{ readonly of: string; readonly source: string; readonly made: T | null } | null>(null);
  useEffect(() => {
    let gone = false;
    void make(() => !gone).then((made) => {
      if (!gone) put({ of, source, made });
    });
    return () => {
      gone = true;
    };
  }, [of, source, make]);
  const isOf = last?.of === of;
  return { made: isOf ? last.made : undefined, working: !isOf || last.source !== source };
}
