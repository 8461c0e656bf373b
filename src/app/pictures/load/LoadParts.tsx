import { Suspense } from "react";
import { lazyPart } from "../../base/parts.ts";
import { useSettings } from "../../base/settings/settings.ts";
import type { LoadLinesProps } from "./LoadLines.tsx";
import type { LoadMarkProps } from "./LoadMark.tsx";
import type { LoadStripProps } from "./LoadStrip.tsx";
import type { LoadTableProps } from "./LoadTable.tsx";

/*
 * Colour map of roughness and load in the lathe view. Nothing is loaded, calculated or drawn before it is switched on.
 */
const Lines = lazyPart(async () => ({ default: (await import("./LoadLines.tsx")).LoadLines }));
const Mark = lazyPart(async () => ({ default: (await import("./LoadMark.tsx")).LoadMark }));
const Strip = lazyPart(async () => ({ default: (await import("./LoadStrip.tsx")).LoadStrip }));
const Table = lazyPart(async () => ({ default: (await import("./LoadTable.tsx")).LoadTable }));

/** The quantity of the colour map, or null. */
function useLoadQuantity() {
  const colours = useSettings((s) => s.colours);
  return colours === "none" ? null : colours;
}

/** Lines in part space, over the path. */
function LazyLoadLines(props: Omit<LoadLinesProps, "of">) {
  const of = useLoadQuantity();
  return (
    of && (
      <Suspense>
        <Lines {...props} of={of} />
      </Suspense>
    )
  );
}

/** The mark of the highest value. */
function LazyLoadMark(props: Omit<LoadMarkProps, "of">) {
  const of = useLoadQuantity();
  return (
    of && (
      <Suspense>
        <Mark {...props} of={of} />
      </Suspense>
    )
  );
}

/** The scale with its numbers. */
function LazyLoadStrip(props: Omit<LoadStripProps, "of">) {
  const of = useLoadQuantity();
  return (
    of && (
      <Suspense>
        <Strip {...props} of={of} />
      </Suspense>
    )
  );
}

/** The table of the highest values. */
function LazyLoadTable(props: Omit<LoadTableProps, "of">) {
  const of = useLoadQuantity();
  return (
    of && (
      <Suspense>
        <Table {...props} of={of} />
      </Suspense>
    )
  );
}

export const LoadPart = { Lines: LazyLoadLines, Mark: LazyLoadMark, Strip: LazyLoadStrip, Table: LazyLoadTable };
