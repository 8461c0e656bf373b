import { useEffect, useState } from "react";
import type { StartPictures } from "./pictures.ts";
import { takeAnswer } from "../../app/base/until-gone.ts";

/** Pictures of programs, once loaded: the first screen does not wait for them. */
export function usePictures(): StartPictures | null {
  const [pictures, take] = useState<StartPictures | null>(null);
  useEffect(
    () =>
      takeAnswer(
        () => import("virtual:start-pictures").catch(() => null),
        (made) => take(made?.pictures ?? null),
      ),
    [],
  );
  return pictures;
}
