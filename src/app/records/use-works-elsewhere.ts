import { useEffect, useState } from "react";
import { refreshWorks } from "./keep.ts";
import { onChanged, worksElsewhere } from "./tab.ts";

const NONE: ReadonlySet<string> = new Set();

/**
 * The works that other tabs have open, followed while a list of works is shown: the list is read again when it changes
 * there.
 */
export function useWorksElsewhere(): ReadonlySet<string> {
  const [works, set] = useState(NONE);
  useEffect(() => {
    let gone = false;
    const ask = () => void worksElsewhere().then((found) => !gone && set(found.size > 0 ? found : NONE));
    const stop = onChanged(() => {
      ask();
      void refreshWorks();
    });
    ask();
    return () => {
      gone = true;
      stop();
    };
  }, []);
  return works;
}
