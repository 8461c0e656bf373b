import { useEffect, useState } from "react";
import type { StartPictures } from "./pictures.ts";

/** What the page shows of programs, once it is here: the first screen does not wait for it. */
export function usePictures(): StartPictures | null {
  const [pictures, take] = useState<StartPictures | null>(null);
  useEffect(() => {
    let here = true;
    void import("virtual:start-pictures").then((made) => here && take(made.pictures)).catch(() => undefined);
    return () => {
      here = false;
    };
  }, []);
  return pictures;
}
