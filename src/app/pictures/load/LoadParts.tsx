import type { ComponentType } from "react";
import { lazyPart } from "../../base/parts.ts";
import { useSettings } from "../../base/settings/settings.ts";
import type { LoadLinesProps } from "./LoadLines.tsx";
import type { LoadMarkProps } from "./LoadMark.tsx";
import type { LoadStripProps } from "./LoadStrip.tsx";
import type { LoadTableProps } from "./LoadTable.tsx";
import type { LoadQuantity } from "./use-load.ts";

/** A part of the colour map that is fetched, and calculates and draws, only while the map is switched on. */
function loadPart<Props extends { readonly of: LoadQuantity }>(fetchPart: () => Promise<ComponentType<Props>>) {
  const Part: ComponentType<Props> = lazyPart(async () => ({ default: await fetchPart() }));
  return function ShownLoad(props: Omit<Props, "of">) {
    const of = useSettings((s) => s.colours);
    return of !== "none" && <Part {...({ ...props, of } as Props)} />;
  };
}

/** Colour map of roughness and load in the lathe view: lines over the path, its highest value, scale and table. */
export const LoadPart = {
  Lines: loadPart<LoadLinesProps>(async () => (await import("./LoadLines.tsx")).LoadLines),
  Mark: loadPart<LoadMarkProps>(async () => (await import("./LoadMark.tsx")).LoadMark),
  Strip: loadPart<LoadStripProps>(async () => (await import("./LoadStrip.tsx")).LoadStrip),
  Table: loadPart<LoadTableProps>(async () => (await import("./LoadTable.tsx")).LoadTable),
};
