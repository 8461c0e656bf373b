import { useSyncExternalStore } from "react";
import type { PlaceProjection } from "./place-projection.ts";

/** The view box of a sheet of a picture, which scales its units of the page to CSS pixels. */
export function useViewBox({ subscribe, size }: Pick<PlaceProjection, "subscribe" | "size">): string {
  const { width, height } = useSyncExternalStore(subscribe, size);
  return `0 0 ${width} ${height}`;
}
