import { Suspense } from "react";
import { lazyPart } from "../../base/parts.ts";
import { useSettings } from "../../base/settings/settings.ts";
import type { LoadLinesProps } from "./LoadLines.tsx";
import type { LoadMarkProps } from "./LoadMark.tsx";
import type { LoadStripProps } from "./LoadStrip.tsx";
import type { LoadTableProps } from "./LoadTable.tsx";

/*
 * Roughness and load by colour, where they stand in the lathe view. Nothing is fetched, worked out or drawn before
 * colours are chosen.
 */
const Lines = lazyPart(async () => ({ default: (await import("./LoadLines.tsx")).LoadLines }));
const Mark = lazyPart(async () => ({ default: (await import("./LoadMark.tsx")).LoadMark }));
const Strip = lazyPart(async () => ({ default: (await import("./LoadStrip.tsx")).LoadStrip }));
const Table = lazyPart(async () => ({ default: (await import("./LoadTable.tsx")).LoadTable }));

/** The quantity that is told, or null. */
function useToldLoad() {
  const colours = useSettings((s) => s.colours);
  return colours === "none" ? null : colours;
}

/** What is drawn in part space, over the path. */
function ToldLines(props: Omit<LoadLinesProps, "of">) {
  const of = useToldLoad();
  return (
    of && (
      <Suspense>
        <Lines {...props} of={of} />
      </Suspense>
    )
  );
}

/** The mark of the worst place. */
function ToldMark(props: Omit<LoadMarkProps, "of">) {
  const of = useToldLoad();
  return (
    of && (
      <Suspense>
        <Mark {...props} of={of} />
      </Suspense>
    )
  );
}

/** The scale with its numbers. */
function ToldStrip(props: Omit<LoadStripProps, "of">) {
  const of = useToldLoad();
  return (
    of && (
      <Suspense>
        <Strip {...props} of={of} />
      </Suspense>
    )
  );
}

/** The list. */
function ToldTable(props: Omit<LoadTableProps, "of">) {
  const of = useToldLoad();
  return (
    of && (
      <Suspense>
        <Table {...props} of={of} />
      </Suspense>
    )
  );
}

export const LoadPart = { Lines: ToldLines, Mark: ToldMark, Strip: ToldStrip, Table: ToldTable };
