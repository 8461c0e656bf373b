import { useId } from "react";
import type { Thumbnail } from "../../../view/thumbnail.ts";
import { Drawing } from "../chooser/Drawing.tsx";
import { menuCycle } from "../chooser/menu.ts";
import { PartPicture } from "./PartPicture.tsx";

/** Thumbnail of a work: the part as last seen, or the pictogram of its cycle. */
export function ProgramThumbnail({
  seen,
  cycle,
}: {
  readonly seen: Thumbnail | undefined;
  readonly cycle: number | null;
}) {
  const id = useId();
  const known = cycle === null ? undefined : menuCycle(cycle);
  if (seen || !known) return <PartPicture of={seen} />;
  return <Drawing of={known.pictograms[0]} id={id} turned={known.group === "transverse"} />;
}
