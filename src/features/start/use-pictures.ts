import { useEffect, useState } from "react";
import type { StartPictures } from "./pictures.ts";

/** Pictures of programs, once loaded: the first screen does not wait for them. */
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
