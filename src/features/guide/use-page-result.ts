import { useEffect, useState } from "react";
import { untilGone } from "../../app/base/until-gone.ts";

/** The last result for a page, and whether a recomputation is pending. */
export interface PageResult<T> {
  /** Undefined until the first result for this page, null if it fails. */
  readonly made: T | null | undefined;
  readonly working: boolean;
}

/** Computes something for the page `of`, again whenever `source` changes; keeps the previous result until then. */
export function usePageResult<T>(
  of: string,
  source: string,
  make: (goesOn: () => boolean) => Promise<T | null>,
): PageResult<T> {
  const [last, put] = useState<{ readonly of: string; readonly source: string; readonly made: T | null } | null>(null);
  useEffect(
    () =>
      untilGone(async (isGone) => {
        const made = await make(() => !isGone());
        if (!isGone()) put({ of, source, made });
      }),
    [of, source, make],
  );
  const isOf = last?.of === of;
  return { made: isOf ? last.made : undefined, working: !isOf || last.source !== source };
}
