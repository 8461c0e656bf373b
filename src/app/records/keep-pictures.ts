import { producedParts } from "../../sim/produced-parts.ts";
import { planeThumbnailOf, thumbnailOf } from "../../view/thumbnail.ts";
import { isMadeFrom, useOutcome } from "../calculation/outcome.ts";
import { useEditor } from "../document/store.ts";
import { keepPicture } from "./kept-picture.ts";

/** Delay between a result and its thumbnail, ms; nobody needs thumbnails while typing. */
const REST = 1500;

/** Starts drawing a thumbnail of each work for the list of works. */
export function startKeepingPictures(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const draw = (work: string | null) => {
    clearTimeout(timer);
    timer = undefined;
    const { shown, dimmed } = useOutcome.getState();
    if (work === null || !shown || dimmed || shown.isBeginning) return;
    const { operations, plane, blank, cuboid } = shown.run;
    const made =
      operations.length > 0 ? thumbnailOf(blank, producedParts(shown.simulation)) : planeThumbnailOf(plane, cuboid);
    if (made) keepPicture(work, made);
  };
  const stops = [
    useOutcome.subscribe((now, before) => {
      if (now.shown === before.shown) return;
      clearTimeout(timer);
      timer = now.shown ? setTimeout(() => draw(useEditor.getState().work), REST) : undefined;
    }),
    useEditor.subscribe((now, before) => {
      if (now.work === before.work || timer === undefined) return;
      const { shown } = useOutcome.getState();
      if (shown && before.program && !isMadeFrom(shown, before.program)) clearTimeout(timer);
      else draw(before.work);
    }),
  ];
  return () => {
    clearTimeout(timer);
    for (const stop of stops) stop();
  };
}
